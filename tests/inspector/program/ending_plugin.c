/* SPDX-License-Identifier: MIT
 * A shared object that does what the variable ENDING says as soon as it is loaded. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

__attribute__((constructor)) static void begin(void) {
    const char *how = getenv("ENDING");
    if (!how) return;
    if (strcmp(how, "abort") == 0) abort();
    if (strcmp(how, "kill") == 0) raise(SIGKILL);
    if (strcmp(how, "exit") == 0) exit(0);
    if (strcmp(how, "print") == 0) puts("loaded");
    while (strcmp(how, "hang") == 0) pause();
}

__attribute__((destructor)) static void end(void) {
    const char *how = getenv("ENDING");
    if (how && strcmp(how, "abort at the end") == 0) abort();
}
