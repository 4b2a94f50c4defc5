/* What a module of LinuxCNC uses of rtapi.h, to compile it where LinuxCNC is not installed. */
#ifndef STUB_RTAPI_H
#define STUB_RTAPI_H

#include <stdbool.h>
#include <stdint.h>

#define RTAPI_MSG_ERR 1
void rtapi_print_msg(int level, const char *format, ...) __attribute__((format(printf, 2, 3)));

#define MODULE_AUTHOR(text) extern const char stub_author[sizeof(text)]
#define MODULE_DESCRIPTION(text) extern const char stub_description[sizeof(text)]
#define MODULE_LICENSE(text) extern const char stub_license[sizeof(text)]
#define EXPORT_SYMBOL(name) extern const char stub_exported_##name
/* a test sets a parameter of the module by this */
#define RTAPI_MP_STRING(name, text) \
    void stub_set_##name(char *value); \
    void stub_set_##name(char *value) \
    { \
        name = value; \
    } \
    extern const char stub_text_##name[sizeof(text)]

#endif
