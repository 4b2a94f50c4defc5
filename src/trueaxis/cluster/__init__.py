"""Work that no longer fits one process: tasks on worker processes of this computer or of a running Dask scheduler."""
