// In place of the header of inverse_dynamics_solver: its names of errors.
#pragma once

#include <rclcpp/exceptions/exceptions.hpp>

namespace inverse_dynamics_solver
{

using rclcpp::exceptions::InvalidParameterValueException;
using rclcpp::exceptions::ParameterUninitializedException;
using rclcpp::exceptions::UnimplementedError;

class UninitializedException : public std::runtime_error
{
public:
  UninitializedException()
  : std::runtime_error("not initialized") {}
};

}  // namespace inverse_dynamics_solver
