// In place of ROS 2's own header: what of rclcpp::Parameter a solver of inverse dynamics reads.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rclcpp
{

enum class ParameterType : std::uint8_t
{
  PARAMETER_NOT_SET = 0,
  PARAMETER_INTEGER = 2,
  PARAMETER_DOUBLE = 3,
  PARAMETER_STRING = 4,
  PARAMETER_DOUBLE_ARRAY = 8,
};

class Parameter
{
public:
  using Value = std::variant<std::monostate, std::int64_t, double, std::string, std::vector<double>>;

  Parameter() = default;
  Parameter(std::string name, Value value)
  : name_(std::move(name)), value_(std::move(value)) {}

  ParameterType get_type() const
  {
    constexpr ParameterType types[] = {
      ParameterType::PARAMETER_NOT_SET, ParameterType::PARAMETER_INTEGER, ParameterType::PARAMETER_DOUBLE,
      ParameterType::PARAMETER_STRING, ParameterType::PARAMETER_DOUBLE_ARRAY};
    return types[value_.index()];
  }

  std::int64_t as_int() const {return get<std::int64_t>();}
  double as_double() const {return get<double>();}
  const std::string & as_string() const {return get<std::string>();}
  const std::vector<double> & as_double_array() const {return get<std::vector<double>>();}

private:
  template<typename Type>
  const Type & get() const
  {
    if (!std::holds_alternative<Type>(value_)) {
      throw std::runtime_error("parameter '" + name_ + "' has invalid type");
    }
    return std::get<Type>(value_);
  }

  std::string name_;
  Value value_;
};

}  // namespace rclcpp
