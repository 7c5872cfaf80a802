/* Messages of the models. */
#include "say.h"

#include <stdarg.h>
#include <stdio.h>

bool say(char message[MESSAGE], const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, MESSAGE, format, arguments);
    va_end(arguments);
    return false;
}
