"""Files of instruments as they come from other programs, and the way from them to a folder of measured data."""
