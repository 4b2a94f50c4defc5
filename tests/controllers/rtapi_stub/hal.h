/* What a module of LinuxCNC uses of hal.h. */
#ifndef STUB_HAL_H
#define STUB_HAL_H

#include "rtapi.h"

typedef volatile bool hal_bit_t;
typedef volatile int32_t hal_s32_t;
typedef volatile double hal_float_t;
typedef enum { HAL_IN = 16, HAL_OUT = 32 } hal_pin_dir_t;

int hal_init(const char *name);
int hal_exit(int component);
int hal_ready(int component);
void *hal_malloc(long size);
int hal_pin_bit_newf(hal_pin_dir_t direction, hal_bit_t **pin, int component, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
int hal_pin_s32_newf(hal_pin_dir_t direction, hal_s32_t **pin, int component, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
int hal_pin_float_newf(hal_pin_dir_t direction, hal_float_t **pin, int component, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
int hal_export_funct(
    const char *name, void (*function)(void *, long), void *argument, int uses_fp, int reentrant, int component);

#endif
