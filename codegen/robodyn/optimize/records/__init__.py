"""Records: the best known programs of robots, as text that is kept beside the robots.

A record belongs to exact parameters, or to the function that they make, not to a name. It is read back
without trust: whoever uses it compares it with the recursion first (:mod:`robodyn.kernels.generate`).
"""

from robodyn.optimize.records.find import FOLDER, best_record, bundled_records, folder_beside
from robodyn.optimize.records.record import Record, parse_record
from robodyn.robot.identity import identity

__all__ = ["FOLDER", "Record", "best_record", "bundled_records", "folder_beside", "identity", "parse_record"]
