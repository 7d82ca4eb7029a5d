"""What ``robodyn fleet`` says of simulated fleets, of robodyn's own simulator and of MuJoCo."""
