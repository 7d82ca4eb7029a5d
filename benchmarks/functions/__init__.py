"""Operations of every function, ours beside those of CasADi, SymForce, wrenfold and Pinocchio traced."""
