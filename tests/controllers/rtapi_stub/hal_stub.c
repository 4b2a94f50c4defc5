/* A HAL of pins and one function, for tests of a module. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hal.h"

enum { MOST_PINS = 64, LONGEST = 48 }; /* LONGEST: HAL_NAME_LEN + 1 */

static struct {
    char name[LONGEST];
    int direction;
    double value; /* room for any type */
} pins[MOST_PINS];
static int pin_count;
static void (*update)(void *, long);
static char message[256];

void *stub_pin(const char *name);
int stub_direction(const char *name);
void stub_update(long period);
const char *stub_message(void);

static int number_of(const char *name)
{
    for (int number = 0; number < pin_count; ++number) {
        if (strcmp(pins[number].name, name) == 0) {
            return number;
        }
    }
    return -1;
}

void *stub_pin(const char *name)
{
    return number_of(name) < 0 ? NULL : &pins[number_of(name)].value;
}

int stub_direction(const char *name)
{
    return pins[number_of(name)].direction;
}

void stub_update(long period)
{
    update(NULL, period);
}

const char *stub_message(void)
{
    return message;
}

void rtapi_print_msg(int level, const char *format, ...)
{
    va_list rest;
    (void)level;
    va_start(rest, format);
    vsnprintf(message, sizeof message, format, rest);
    va_end(rest);
}

static void *new_pin(int direction, const char *format, va_list rest)
{
    const int number = pin_count++;
    if (number >= MOST_PINS || vsnprintf(pins[number].name, LONGEST, format, rest) >= LONGEST) {
        abort();
    }
    pins[number].direction = direction;
    return &pins[number].value;
}

#define NEW_PIN(type) \
    int hal_pin_##type##_newf(hal_pin_dir_t direction, hal_##type##_t **pin, int component, const char *format, ...) \
    { \
        va_list rest; \
        (void)component; \
        va_start(rest, format); \
        *pin = new_pin((int)direction, format, rest); \
        va_end(rest); \
        return 0; \
    }
NEW_PIN(bit)
NEW_PIN(s32)
NEW_PIN(float)

int hal_init(const char *name)
{
    return strcmp(name, "trueaxiskins") == 0 ? 7 : -1;
}

int hal_exit(int component)
{
    return component == 7 ? 0 : -1;
}

int hal_ready(int component)
{
    return component == 7 ? 0 : -1;
}

void *hal_malloc(long size)
{
    return calloc(1, (size_t)size);
}

int hal_export_funct(
    const char *name, void (*function)(void *, long), void *argument, int uses_fp, int reentrant, int component)
{
    (void)argument;
    (void)reentrant;
    update = function;
    return strcmp(name, "trueaxiskins.update") == 0 && uses_fp == 1 && component == 7 ? 0 : -1;
}
