// SPDX-License-Identifier: MIT
#include "registry/shared_object_file.h"

#include "base/error.h"
#include "base/system.h"

#if __has_include(<link.h>)
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <link.h>
#include <memory>
#endif

namespace phys {

namespace {

#if __has_include(<link.h>)

using File = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

bool readAt(std::FILE *file, uint64_t offset, void *out, size_t size) {
    return std::fseek(file, static_cast<long>(offset), SEEK_SET) == 0 && std::fread(out, 1, size, file) == size;
}

phys_status refuseShort(const std::string &path, uint64_t expected, uint64_t size, phys_error *err) {
    return failIn(err, PHYS_ERROR_PLUGIN_REFUSED, path, ": expected %llu bytes as its headers say; found %llu",
                  static_cast<unsigned long long>(expected), static_cast<unsigned long long>(size));
}

/// A file that isn't ELF is left to the system's loader, which reports it.
phys_status checkSegments(const std::string &path, phys_error *err) {
    const File file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) return PHYS_OK;
    const long end = std::fseek(file.get(), 0, SEEK_END) == 0 ? std::ftell(file.get()) : 0;
    if (end <= 0) { // includes files that the system generates, on which the loader would block
        return failIn(err, PHYS_ERROR_PLUGIN_REFUSED, path, ": expected a shared object; found a file of size 0");
    }
    const auto size = static_cast<uint64_t>(end);
    ElfW(Ehdr) header;
    if (!readAt(file.get(), 0, &header, sizeof header)) return PHYS_OK;
    if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_phentsize != sizeof(ElfW(Phdr))) return PHYS_OK;
    for (uint64_t i = 0; i < header.e_phnum; ++i) {
        ElfW(Phdr) segment;
        const uint64_t offset = header.e_phoff + i * sizeof segment;
        if (offset > size || !readAt(file.get(), offset, &segment, sizeof segment)) {
            return refuseShort(path, offset + sizeof segment, size, err);
        }
        const bool fits = segment.p_filesz <= size && segment.p_offset <= size - segment.p_filesz;
        if (!fits) return refuseShort(path, segment.p_offset + segment.p_filesz, size, err);
    }
    return PHYS_OK;
}

/// A line of /proc/self/maps: "begin-end rights offset device inode path", with " (deleted)" behind the path.
bool isDeletedAt(const char *line, uintptr_t address) {
    uint64_t begin = 0, end = 0;
    if (std::sscanf(line, "%" SCNx64 "-%" SCNx64, &begin, &end) != 2) return false;
    return begin <= address && address < end && std::strstr(line, " (deleted)\n");
}

#else

phys_status checkSegments(const std::string &, phys_error *) { return PHYS_OK; }

#endif

} // namespace

phys_status checkSharedObjectFile(const std::string &path, phys_error *err) {
    const std::string reason = system::whyNoFile(path);
    if (!reason.empty()) return failIn(err, PHYS_ERROR_FILE, path, ": %s", reason.c_str());
    return checkSegments(path, err);
}

bool isOfDeletedFile([[maybe_unused]] const void *address) {
#if __has_include(<link.h>)
    const File maps(std::fopen("/proc/self/maps", "re"), std::fclose);
    char line[8192]; // a path has up to 4095 bytes
    while (maps && std::fgets(line, sizeof line, maps.get())) {
        if (isDeletedAt(line, reinterpret_cast<uintptr_t>(address))) return true;
    }
#endif
    return false;
}

} // namespace phys
