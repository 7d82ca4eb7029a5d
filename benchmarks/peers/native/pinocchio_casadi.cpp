// Traces Pinocchio's algorithms over CasADi's SX: pinocchio_casadi FOLDER NAME...
// Of each function NAME of pinocchio_functions.hpp it leaves in the working folder pinocchio_NAME.casadi, which CasADi
// loads, and what CasADi writes: pinocchio_NAME.c, and after casadi.cse pinocchio_NAME_cse.c.
#include <pinocchio/autodiff/casadi.hpp>

#include "pinocchio_functions.hpp"

#include <cstring>

using Scalar = casadi::SX;

template <typename S, int O> struct TwoJoints {
    static constexpr int Options = O;
    using JointModelRZ = pinocchio::JointModelRevoluteTpl<S, O, 2>;
    using JointModelPZ = pinocchio::JointModelPrismaticTpl<S, O, 2>;
    using JointDataRZ = pinocchio::JointDataRevoluteTpl<S, O, 2>;
    using JointDataPZ = pinocchio::JointDataPrismaticTpl<S, O, 2>;
    using JointModelMimic = pinocchio::JointModelMimicTpl<S, O, TwoJoints>; // which Pinocchio asks for by name
    using JointDataMimic = pinocchio::JointDataMimicTpl<S, O, TwoJoints>;
    using JointModelVariant = boost::variant<JointModelRZ, JointModelPZ, boost::recursive_wrapper<JointModelMimic>>;
    using JointDataVariant = boost::variant<JointDataRZ, JointDataPZ, boost::recursive_wrapper<JointDataMimic>>;
};

using Numbers = pinocchio::ModelTpl<double, 0, TwoJoints>;
using Traced = Arm<Scalar, TwoJoints>;

template <typename F> static void trace(const Numbers &numbers, const std::string &name)
{
    Traced arm(numbers);
    const int n = arm.n(), size = F::size(n);
    const Scalar q = Scalar::sym("q", n), qd = Scalar::sym("qd", n), third = Scalar::sym("third", n);
    Traced::Vector x(n), v(n), a(n);
    for (int i = 0; i < n; i++) {
        x[i] = q(i);
        v[i] = qd(i);
        a[i] = third(i);
    }
    std::vector<Scalar> results(size);
    F::run(arm, x, v, a, results.data());
    const Scalar all = Scalar::vertcat(results);
    for (const bool merged : {false, true}) {
        const std::string called = "pinocchio_" + name + (merged ? "_cse" : "");
        casadi::Dict options;
        options["cse"] = merged;
        casadi::Function function(called, {q, qd, third}, {casadi::SX::densify(all)}, options);
        function.generate(called + ".c");
        if (merged)
            function.save("pinocchio_" + name + ".casadi");
    }
}

int main(int argc, char **argv)
{
    peer_arm arm;
    if (argc < 3 || peer_read_arm(argv[1], &arm))
        return 2;
    const auto numbers = pinocchio_arm<Numbers>(arm);
    for (int k = 2; k < argc; k++) {
#define TRACED(NAME)                                                                                                   \
    if (!std::strcmp(argv[k], #NAME))                                                                                  \
        trace<functions::NAME>(numbers, #NAME);
        EVERY_FUNCTION(TRACED)
    }
    return 0;
}
