"""What stands between a motor and its link."""
