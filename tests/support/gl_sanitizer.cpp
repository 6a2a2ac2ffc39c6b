// SPDX-License-Identifier: MIT
// Linked into tests that open a screen when AddressSanitizer is on. OpenGL drivers are unloaded at exit, before the
// search for leaks, so that the memory they keep is reported as lost in an unknown module that no suppression can name.
// Keeping every module loaded gives these blocks a reachable owner. The drivers' thread-local blocks aren't scanned,
// because LLVM 14's search for leaks occasionally crashes in them.
extern "C" {

int dlclose(void *) { return 0; }

const char *__asan_default_options() { return "intercept_tls_get_addr=0"; }

const char *__lsan_default_suppressions() {
    return "leak:libdbus-1.so\nleak:swrast_dri.so\nleak:libGLX_mesa.so\nleak:libfontconfig.so\n";
}
}
