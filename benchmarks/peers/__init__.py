"""Our kernels raced against Pinocchio, CasADi, SymForce, wrenfold, MuJoCo, KDL and the Robotics Toolbox."""
