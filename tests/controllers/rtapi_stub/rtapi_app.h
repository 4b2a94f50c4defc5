#ifndef STUB_RTAPI_APP_H
#define STUB_RTAPI_APP_H

int rtapi_app_main(void);
void rtapi_app_exit(void);

#endif
