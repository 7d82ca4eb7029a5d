// A node's part: loads a solver by the name of its plugin, initializes it and calls it.
//   consumer PLUGIN JOINTS METHOD,METHOD... STATES [NAME=NUMBER | NAME=TEXT | NAME=X,Y,Z]...
// reads the arguments of each method at each state from stdin, and prints the results. What is wrong with the
// solver ends it in 1; what the solver refuses is printed.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

#include <inverse_dynamics_solver/inverse_dynamics_solver.hpp>
#include <pluginlib/class_loader.hpp>

using Solver = inverse_dynamics_solver::InverseDynamicsSolver;
using Eigen::VectorXd;

// Every allocation of the process, by new and by Eigen.
static std::size_t allocations = 0;
extern "C" void * __libc_malloc(std::size_t size);
extern "C" void * malloc(std::size_t size)
{
  ++allocations;
  return __libc_malloc(size);
}
extern "C" void * __libc_calloc(std::size_t count, std::size_t size);
extern "C" void * calloc(std::size_t count, std::size_t size)
{
  ++allocations;
  return __libc_calloc(count, size);
}

class Node : public rclcpp::node_interfaces::NodeParametersInterface
{
public:
  void set(const std::string & name, rclcpp::Parameter::Value value) {values_[name] = {name, value};}
  bool has_parameter(const std::string & name) const override {return values_.count(name) > 0;}
  rclcpp::Parameter get_parameter(const std::string & name) const override {return values_.at(name);}
  bool get_parameter(const std::string & name, rclcpp::Parameter & parameter) const override
  {
    const bool known = has_parameter(name);
    if (known) {
      parameter = values_.at(name);
    }
    return known;
  }

private:
  std::map<std::string, rclcpp::Parameter> values_;
};

static rclcpp::Parameter::Value value_of(const std::string & text)
{
  std::vector<double> numbers;
  std::stringstream words(text);
  for (std::string word; std::getline(words, word, ','); ) {
    char * end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (word.empty() || *end != '\0') {
      return text;
    }
  }
  if (numbers.size() > 1) {
    return numbers;
  }
  const bool whole = text.find('.') == std::string::npos;
  return whole ? rclcpp::Parameter::Value(std::int64_t(numbers.at(0))) : rclcpp::Parameter::Value(numbers.at(0));
}

static VectorXd next(int n)
{
  VectorXd values(n);
  for (int i = 0; i < n; ++i) {
    if (!(std::cin >> values[i])) {
      throw std::runtime_error("stdin ends early");
    }
  }
  return values;
}

template<typename Values>
static void print(const Values & values)
{
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    for (Eigen::Index j = 0; j < values.cols(); ++j) {
      std::printf("%.17g\n", values(i, j));
    }
  }
}

template<typename Call>
static auto counted(std::size_t expected, const char * method, Call call)
{
  const std::size_t before = allocations;
  auto result = call();
  const std::size_t allocated = allocations - before;
  if (allocated != expected) {
    throw std::logic_error(std::string(method) + ": " + std::to_string(allocated) + " allocations");
  }
  return result;
}

static void call(const Solver & solver, const std::string & method, int n)
{
  const VectorXd q = next(n);
  if (method == "mass_matrix") {
    print(counted(1, "getInertiaMatrix", [&] {return solver.getInertiaMatrix(q);}));
  } else if (method == "gravity") {
    print(counted(1, "getGravityVector", [&] {return solver.getGravityVector(q);}));
  } else {
    const VectorXd qd = next(n);
    const VectorXd qdd = method == "inverse_dynamics" ? next(n) : VectorXd::Zero(n);
    if (method == "coriolis") {
      print(counted(1, "getCoriolisVector", [&] {return solver.getCoriolisVector(q, qd);}));
    } else {
      print(counted(1, "getTorques", [&] {return solver.getTorques(q, qd, qdd);}));
    }
  }
}

// The terms of the equation of motion are those of the torques, and none allocates more than it returns.
static void check_the_sum(const Solver & solver, int n)
{
  const VectorXd q = VectorXd::LinSpaced(n, 0.2, 0.9);
  const VectorXd qd = VectorXd::LinSpaced(n, -1.1, 0.8);
  const VectorXd qdd = VectorXd::LinSpaced(n, 2.0, -1.5);
  const auto [M, cqd, gravity] = counted(3, "getDynamicParameters", [&] {return solver.getDynamicParameters(q, qd);});
  const VectorXd friction = counted(1, "getFrictionVector", [&] {return solver.getFrictionVector(qd);});
  const VectorXd sum = M * qdd + cqd + gravity + friction;
  const VectorXd torques = solver.getTorques(q, qd, qdd);
  if (!((sum - torques).cwiseAbs().maxCoeff() <= 1e-5 * (1 + torques.cwiseAbs().maxCoeff()))) {
    throw std::logic_error("the terms are not those of the torques");
  }
  std::cerr << "friction " << friction.transpose() << "\n";
}

int main(int argc, char ** argv)
{
  const std::string plugin = argv[1];
  const int n = std::atoi(argv[2]);
  const int states = std::atoi(argv[4]);
  auto node = std::make_shared<Node>();
  for (int i = 5; i < argc; ++i) {
    const std::string argument = argv[i];
    const auto equals = argument.find('=');
    std::string text = argument.substr(equals + 1);
    if (text.rfind("@", 0) == 0) {
      std::ifstream file(text.substr(1));
      text.assign(std::istreambuf_iterator<char>(file), {});
    }
    node->set(argument.substr(0, equals), value_of(text));
  }
  pluginlib::ClassLoader<Solver> loader("inverse_dynamics_solver", "inverse_dynamics_solver::InverseDynamicsSolver");
  auto solver = loader.createUniqueInstance(plugin);
  try {
    solver->getGravityVector(VectorXd::Zero(n));
    return 1;  // before it is initialized
  } catch (const std::runtime_error &) {
  }
  try {
    solver->initialize(node, "dynamics_solver");
  } catch (const std::exception & error) {
    std::printf("refused: %s\n", error.what());
    return 0;
  }
  try {
    solver->getGravityVector(VectorXd::Zero(n + 1));
    return 1;  // of another size
  } catch (const std::invalid_argument &) {
  }
  std::stringstream methods(argv[3]);
  for (std::string method; std::getline(methods, method, ','); ) {
    for (int i = 0; i < states; ++i) {
      call(*solver, method, n);
    }
  }
  try {
    check_the_sum(*solver, n);
  } catch (const std::runtime_error & error) {
    std::cerr << error.what() << "\n";  // friction that is no function of the velocities
  }
  return 0;
}
