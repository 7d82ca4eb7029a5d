// ssik's native backend, from its headers: the function of an arm's family that gives all solutions of a pose, without
// what its Solver puts around it (checks, limits, the rescue of singular poses), which only takes longer. FAMILY: its
// header; SOLVE(pose): the call. Where a joint is redundant that is a sweep over its positions.
#include "inverse.hpp"

#include FAMILY

#include <map>

static std::vector<ssik::Pose> poses;
static std::vector<double> near;
static std::vector<std::vector<ssik::Solution<JOINTS>>> solutions;
static std::map<std::string, std::vector<double>> numbers;
static ssik::JointConsts<JOINTS> joints;

static Eigen::Map<const Eigen::Vector3d> vector(const char *name, int from = 0)
{
    return Eigen::Map<const Eigen::Vector3d>(numbers.at(name).data() + from);
}

static Eigen::Matrix4d frame(const char *name, int from)
{
    return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.at(name).data() + from);
}

#ifdef SRS
static ssik::SrsConsts srs;

static void prepare()
{
    srs.l_se = numbers.at("l_se")[0];
    srs.l_ew = numbers.at("l_ew")[0];
    srs.ee_offset_local = vector("ee_offset_local");
    srs.shoulder_pivot = vector("shoulder_pivot");
    srs.upper_home = vector("upper_home");
    srs.forearm_home = vector("forearm_home");
    for (int i = 0; i < 9; i++)
        srs.r_post_wrist(i / 3, i % 3) = numbers.at("r_post_wrist")[i];
    srs.elbow_index = (int)numbers.at("elbow_index")[0];
    srs.general_path = numbers.at("general_path")[0] != 0;
}

static std::vector<ssik::Solution<7>> swept(const ssik::Pose &pose)
{
    return srs.general_path ? ssik::srs_general_solve(joints, srs, pose) : ssik::srs_canonical_solve(joints, srs, pose);
}
#elif defined SHOULDER
static ssik::SphericalShoulderConsts shoulder;

static void prepare()
{
    for (int i = 0; i < 3 * 48; i++)
        shoulder.coef(i / 48, i % 48) = numbers.at("coef")[i];
}

static std::vector<ssik::Solution<7>> swept(const ssik::Pose &pose)
{
    return ssik::spherical_shoulder_core(joints, shoulder, pose, false, 0);
}

// Its closed form at one position of the last joint, as the sweep calls it.
static std::vector<ssik::Solution<7>> at_one(const ssik::Pose &pose, double last)
{
    std::vector<ssik::Solution<7>> all;
    for (const auto &q : ssik::sh_detail::closed_branches(shoulder.coef, pose.inverse(), last, ssik::Tolerances())) {
        const double left = (ssik::fk<7>(joints, q) - pose).norm();
        if (left <= ssik::kShFkAtol)
            all.push_back(ssik::Solution<7>{q, left, ssik::Refinement::None});
    }
    return all;
}
#else
static void prepare()
{
}
#endif

// solver.txt: array by array its name, how many numbers it has, and these.
extern "C" int peer_open(const char *folder, int count, int n, const double *T, const double *q_near, const double *)
{
    std::ifstream file(std::string(folder) + "/solver.txt");
    std::string name;
    std::size_t size;
    if (n != TWELVE)
        return 1;
    while (file >> name >> size) {
        numbers[name].resize(size);
        for (double &x : numbers[name])
            file >> x;
    }
    if (numbers.count("axis") == 0 || numbers["axis"].size() != 3 * JOINTS)
        return 1;
    for (int i = 0; i < JOINTS; i++) {
        joints.axis[i] = vector("axis", 3 * i);
        joints.t_left[i] = frame("t_left", 16 * i);
        joints.t_right[i] = frame("t_right", 16 * i);
        joints.type[i] = ssik::JointType::Revolute;
    }
    prepare();
    for (int k = 0; k < count; k++) {
        poses.push_back(pose_of(T + k * n));
        near.push_back(q_near[k * n + JOINTS - 1]);
    }
    solutions.resize(count);
    return 0;
}

extern "C" void peer_run(void)
{
    for (std::size_t k = 0; k < poses.size(); k++)
        solutions[k] = SOLVE(k);
}

extern "C" int peer_size(int)
{
    return 1 + SLOTS * JOINTS;
}

extern "C" void peer_result(double *out)
{
    for (const auto &all : solutions)
        hand_out(out, (int)all.size(), JOINTS, [&](int slot) { return all[slot].q.data(); });
}
