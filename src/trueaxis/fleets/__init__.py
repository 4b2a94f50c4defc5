"""Many machines, each with measured data of many days: their file, what has been done of it, what it comes to."""
