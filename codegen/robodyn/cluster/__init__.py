"""Where independent pieces of work run: in this process, in others of this machine, on a Dask scheduler."""

from robodyn.cluster.cluster import Cluster, Security
from robodyn.cluster.opening import check_place, open_cluster
from robodyn.cluster.work import Done, Failed

__all__ = ["Cluster", "Done", "Failed", "Security", "check_place", "open_cluster"]
