// Writes the C that CasADi makes of Pinocchio's rnea: pinocchio_casadi FOLDER NAME CSE
#include <pinocchio/autodiff/casadi.hpp>

#include "pinocchio_arm.hpp"
#include <pinocchio/algorithm/rnea.hpp>

int main(int, char **argv)
{
    using Scalar = casadi::SX;
    using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    peer_arm arm;
    if (peer_read_arm(argv[1], &arm))
        return 2;
    const auto model = pinocchio_arm(arm).cast<Scalar>();
    pinocchio::DataTpl<Scalar> data(model);
    const Scalar q = Scalar::sym("q", arm.n), qd = Scalar::sym("qd", arm.n), qdd = Scalar::sym("qdd", arm.n);
    Vector eq(arm.n), eqd(arm.n), eqdd(arm.n);
    for (int i = 0; i < arm.n; i++) {
        eq[i] = q(i);
        eqd[i] = qd(i);
        eqdd[i] = qdd(i);
    }
    pinocchio::rnea(model, data, eq, eqd, eqdd);
    Scalar tau(arm.n, 1);
    for (int i = 0; i < arm.n; i++)
        tau(i) = data.tau[i];
    casadi::Dict options;
    options["cse"] = argv[3][0] == '1';
    casadi::Function function(argv[2], {q, qd, qdd}, {tau}, options);
    function.generate(std::string(argv[2]) + ".c");
    return 0;
}
