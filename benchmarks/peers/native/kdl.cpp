// KDL's recursive Newton-Euler (ChainIdSolver_RNE), states in its own arrays from the start.
#include "peer.h"
#include <kdl/chain.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

#include <memory>
#include <vector>

static std::vector<KDL::JntArray> q, qd, qdd, tau;
static std::unique_ptr<KDL::ChainIdSolver_RNE> solver;
static KDL::Chain chain;
static KDL::Wrenches wrenches;

static KDL::JntArray array(const double *from, int n)
{
    KDL::JntArray values(n);
    for (int i = 0; i < n; i++)
        values(i) = from[i];
    return values;
}

static KDL::Frame placed(const peer_link &link)
{
    const double *r = link.rotation;
    return KDL::Frame(KDL::Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]),
                      KDL::Vector(link.position[0], link.position[1], link.position[2]));
}

extern "C" int peer_open(const char *folder, int count, int n, const double *p, const double *v, const double *a)
{
    peer_arm arm;
    if (peer_read_arm(folder, &arm) || arm.n != n)
        return 1;
    // As KDL has it: a segment's joint stands at its root and turns about z there; its tip is where the next
    // joint is mounted, and its inertia is given at the tip.
    if (!KDL::Equal(placed(arm.link[0]), KDL::Frame::Identity(), 0))
        chain.addSegment(KDL::Segment("base", KDL::Joint(KDL::Joint::None), placed(arm.link[0])));
    for (int i = 0; i < n; i++) {
        const peer_link &link = arm.link[i];
        const double *j = link.inertia;
        const KDL::Frame tip = i + 1 < n ? placed(arm.link[i + 1]) : KDL::Frame::Identity();
        const KDL::Vector com(link.com[0], link.com[1], link.com[2]);
        const KDL::RigidBodyInertia body(link.mass, com, KDL::RotationalInertia(j[0], j[4], j[8], j[1], j[2], j[5]));
        const auto kind = link.revolute != 0 ? KDL::Joint::RotZ : KDL::Joint::TransZ;
        const KDL::Joint joint("joint" + std::to_string(i + 1), kind, 1, 0, link.rotor);
        chain.addSegment(KDL::Segment("link" + std::to_string(i + 1), joint, tip, tip.Inverse() * body));
    }
    solver = std::make_unique<KDL::ChainIdSolver_RNE>(chain, KDL::Vector(arm.gravity[0], arm.gravity[1], arm.gravity[2]));
    wrenches.assign(chain.getNrOfSegments(), KDL::Wrench::Zero());
    for (int k = 0; k < count; k++) {
        q.push_back(array(p + k * n, n));
        qd.push_back(array(v + k * n, n));
        qdd.push_back(array(a + k * n, n));
        tau.push_back(KDL::JntArray(n));
    }
    return 0;
}

extern "C" void peer_run(void)
{
    for (std::size_t k = 0; k < q.size(); k++)
        solver->CartToJnt(q[k], qd[k], qdd[k], wrenches, tau[k]);
}

extern "C" void peer_result(double *out)
{
    for (const auto &one : tau)
        for (unsigned i = 0; i < one.rows(); i++)
            *out++ = one(i);
}
