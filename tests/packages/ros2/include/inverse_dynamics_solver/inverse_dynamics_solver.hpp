// In place of the header of inverse_dynamics_solver 1.0 (Humble), 2.0 (Jazzy) and 6.0 (Rolling): the methods
// that it declares, with its signatures and defaults.
#pragma once

#include <string>
#include <tuple>

#include <Eigen/Core>
#include <rclcpp/node_interfaces/node_parameters_interface.hpp>

namespace inverse_dynamics_solver
{

class InverseDynamicsSolver
{
public:
  using Vector = Eigen::VectorXd;
  using Parameters = rclcpp::node_interfaces::NodeParametersInterface::ConstSharedPtr;

  virtual ~InverseDynamicsSolver() = default;

  virtual void initialize(
    Parameters parameters_interface = nullptr, const std::string & param_namespace = "",
    const std::string & robot_description = "") = 0;

  virtual std::tuple<Eigen::MatrixXd, Vector, Vector> getDynamicParameters(const Vector & q, const Vector & qd) const
  {
    return {getInertiaMatrix(q), getCoriolisVector(q, qd), getGravityVector(q)};
  }

  virtual Eigen::MatrixXd getInertiaMatrix(const Vector & q) const = 0;
  virtual Vector getCoriolisVector(const Vector & q, const Vector & qd) const = 0;
  virtual Vector getGravityVector(const Vector & q) const = 0;
  virtual Vector getFrictionVector(const Vector & qd) const = 0;

  virtual Vector getTorques(const Vector & q, const Vector & qd, const Vector & qdd) const
  {
    return getInertiaMatrix(q) * qdd + getCoriolisVector(q, qd) + getGravityVector(q);
  }

protected:
  InverseDynamicsSolver() = default;
};

}  // namespace inverse_dynamics_solver
