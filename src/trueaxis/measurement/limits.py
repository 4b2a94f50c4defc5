"""What no measurement on a machine tool exceeds: beyond it a value is in another unit, or of another column."""

# degC: far outside any workshop; room temperature in kelvin is beyond
COLDEST, WARMEST = -100.0, 200.0
LONGEST_TIME = 1e10  # s: 300 years; seconds since 1970 are 2e9, milliseconds since 1970 are beyond
FASTEST = 1e6  # mm/min: linear motors reach 2e5
FARTHEST_POINT = 1e5  # mm, from the origin of a frame: the largest gantry machines travel 6e4
LONGEST_ID = 100  # characters of the id of a run
MOST_COLUMNS = 300  # of a table: a few dozen are known; the rest are temperatures of sensors
NOISE_UM = (1e-6, 1e4)  # of a reading, um: a picometre to a centimetre; beyond, it is in another unit, or a slip
