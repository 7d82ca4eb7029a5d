// In place of ROS 2's own header: the errors that solvers throw.
#pragma once

#include <stdexcept>
#include <string>

namespace rclcpp::exceptions
{

class UnimplementedError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class InvalidParameterValueException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class ParameterUninitializedException : public std::runtime_error
{
public:
  explicit ParameterUninitializedException(const std::string & name)
  : std::runtime_error("parameter '" + name + "' is not initialized") {}
};

}  // namespace rclcpp::exceptions
