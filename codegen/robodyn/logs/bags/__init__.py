"""Recordings of ROS 2: MCAP and rosbag2's databases, messages in CDR."""
