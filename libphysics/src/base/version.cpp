// SPDX-License-Identifier: MIT
#include <physics/physics.h>

#define PHYS_TEXT_OF(number) #number
#define PHYS_TEXT(number) PHYS_TEXT_OF(number)

const char *phys_version(void) {
    return PHYS_TEXT(PHYS_VERSION_MAJOR) "." PHYS_TEXT(PHYS_VERSION_MINOR) "." PHYS_TEXT(PHYS_VERSION_PATCH);
}
