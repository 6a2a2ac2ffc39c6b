// SPDX-License-Identifier: MIT
// Any bytes as a maze file and as a maze in memory: a scene, or one line with the reason.
#include "input.h"

#include <physics/physics.h>

#include <cstdio>
#include <sys/mman.h>
#include <unistd.h>

namespace {

/// A file in memory with these bytes; its path is short-lived.
class MemoryFile {
public:
    MemoryFile(const uint8_t *data, size_t size)
        : m_file(memfd_create("maze", 0)) {
        fuzz::demand(m_file >= 0 && write(m_file, data, size) == static_cast<ssize_t>(size));
        std::snprintf(m_path, sizeof m_path, "/proc/self/fd/%d", m_file);
    }
    ~MemoryFile() { close(m_file); }
    MemoryFile(const MemoryFile &) = delete;
    MemoryFile &operator=(const MemoryFile &) = delete;
    const char *path() const { return m_path; }

private:
    int m_file;
    char m_path[40];
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const MemoryFile file(data, size);
    phys_scene *scene = nullptr;
    phys_error error{};
    const phys_status status = phys_scene_load(file.path(), &scene, &error);
    phys_scene *parsed = nullptr;
    fuzz::demand(phys_scene_parse(reinterpret_cast<const char *>(data), size, nullptr, &parsed, nullptr) == status);
    phys_scene_destroy(parsed);
    if (status) {
        fuzz::demand(!scene && error.status == status && error.text[0] != '\0');
        fuzz::demand(!std::strchr(error.text, '\n'));
        return 0;
    }
    fuzz::demand(scene && phys_scene_radius(scene) > 0.0);
    phys_scene_destroy(scene);
    return 0;
}
