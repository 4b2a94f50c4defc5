"""Real NC programs, graded through LinuxCNC's interpreter and a machine of matrices; nothing here uses src's readers.

`python -m tests.shop_programs fetch DIR` gets LinuxCNC's own sample programs and its interpreter from the Debian
package `linuxcnc-uspace`, unpacked into DIR and not installed. `python -m tests.shop_programs grade DIR FOLDER...` runs
every program below the folders given, `... klartext FOLDER...` those of Heidenhain Klartext by a control of
the tests. The programs are no part of the repository.
"""
