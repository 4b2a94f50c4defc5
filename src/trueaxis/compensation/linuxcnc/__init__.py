"""Has an installed interpreter of LinuxCNC unroll a program first, see interpreter."""
