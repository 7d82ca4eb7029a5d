"""The book: recursions over any scalar, kinematics, derivatives, regressor, and the table of functions.

Modules and packages from the bottom to the top, each of which imports only those that stand before it:

- numbers and frames: ``limits vectors arm transforms``
- one arm, and what its functions ask of it: ``lump parallel state``
- motion of frames: ``kinematics sections poses jacobians dual``
- masses: ``regroup spatial weights momenta mass_matrix``
- recursions: ``joints newton_euler modified_newton_euler derivatives articulated``
- what rests on recursions: ``operational regressor base_set reference``
- joint positions of a pose: ``inverse``
- the table of functions: ``functions``
- programs of functions, put together and proven: ``compose closure equality``
"""
