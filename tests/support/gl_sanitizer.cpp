// SPDX-License-Identifier: MIT
// Linked into tests that open a screen when AddressSanitizer is on. OpenGL drivers are unloaded at exit, before leaks
// are looked for, so that what they keep shows up as lost in an unknown module that no suppression can name. Keeping
// every module loaded gives the blocks their owners back; those owners are not ours. Without following the drivers'
// thread-local blocks, in which LLVM 14's search for leaks now and then crashes.
extern "C" {

int dlclose(void *) { return 0; }

const char *__asan_default_options() { return "intercept_tls_get_addr=0"; }

const char *__lsan_default_suppressions() {
    return "leak:libdbus-1.so\nleak:swrast_dri.so\nleak:libGLX_mesa.so\nleak:libfontconfig.so\n";
}
}
