/* Part of the LinuxCNC kinematics module that trueaxis writes.
 * SPDX-License-Identifier: MIT
 * Which joint has which axis letter: the parameter `coordinates`, as trivkins has it.
 */
#ifndef TRUEAXIS_JOINTS_H
#define TRUEAXIS_JOINTS_H

#define MOST_JOINTS 16 /* EMCMOT_MAX_JOINTS */

static char *coordinates = AXIS_LETTERS;
RTAPI_MP_STRING(coordinates, "Axis letter of each joint");

static const char LETTERS[] = "XYZABCUVW";
static int joint_count;
static int letter_of_joint[MOST_JOINTS]; /* index in LETTERS */
static int joint_of_axis[AXES];          /* of joints with one letter the first */

static double *coordinate(EmcPose *world, int letter)
{
    double *const all[] = { &world->tran.x, &world->tran.y, &world->tran.z, &world->a, &world->b, &world->c,
        &world->u, &world->v, &world->w };
    return all[letter];
}

static int letter_index(char letter)
{
    for (int index = 0; LETTERS[index] != '\0'; ++index) {
        if (letter == LETTERS[index] || letter == LETTERS[index] + ('a' - 'A')) {
            return index;
        }
    }
    return -1;
}

/* Reads `coordinates`; -1 where a letter is none, an axis of the machine is missing, or joints are too many. */
static int read_coordinates(void)
{
    joint_count = 0;
    for (const char *next = coordinates; *next != '\0'; ++next) {
        const int letter = letter_index(*next);
        if (*next == ' ') {
            continue;
        }
        if (letter < 0 || joint_count == MOST_JOINTS) {
            rtapi_print_msg(RTAPI_MSG_ERR, "trueaxiskins: coordinates=%s: expected up to %d letters of %s\n",
                coordinates, MOST_JOINTS, LETTERS);
            return -1;
        }
        letter_of_joint[joint_count] = letter;
        ++joint_count;
    }
    for (int row = 0; row < AXES; ++row) {
        joint_of_axis[row] = -1;
        for (int joint = joint_count - 1; joint >= 0; --joint) {
            joint_of_axis[row] = letter_of_joint[joint] == AXIS_ROWS[row] ? joint : joint_of_axis[row];
        }
        if (joint_of_axis[row] < 0) {
            rtapi_print_msg(RTAPI_MSG_ERR, "trueaxiskins: coordinates=%s: axis %c of the machine is missing\n",
                coordinates, LETTERS[AXIS_ROWS[row]]);
            return -1;
        }
    }
    return 0;
}

#endif
