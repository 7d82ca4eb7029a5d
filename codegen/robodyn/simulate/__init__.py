"""Motions, controllers, integration and sensors: what stands in for the arm and its log."""
