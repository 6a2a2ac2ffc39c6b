// SPDX-License-Identifier: MIT
#include "base/system.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <dlfcn.h>
#include <locale.h>
#include <memory>
#include <sys/stat.h>

namespace phys::system {

namespace {

/// The C locale for this thread while it lives: messages in English, numbers with a point.
class EnglishHere {
public:
    EnglishHere()
        : m_plain(newlocale(LC_ALL_MASK, "C", nullptr))
        , m_before(m_plain ? uselocale(m_plain) : nullptr) {}
    ~EnglishHere() {
        if (!m_plain) return;
        uselocale(m_before);
        freelocale(m_plain);
    }
    EnglishHere(const EnglishHere &) = delete;
    EnglishHere &operator=(const EnglishHere &) = delete;

private:
    locale_t m_plain, m_before;
};

std::string textOf(int error) {
    const EnglishHere english;
    return std::strerror(error);
}

} // namespace

const char kPathSeparator = ':';
const char *const kObjectSuffix = ".so";

std::string environmentVariable(const char *name) {
    const char *value = std::getenv(name);
    return value ? value : "";
}

std::string readFile(const std::string &path, size_t mostBytes, std::string &out) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return textOf(errno);
    if (!S_ISREG(status.st_mode)) return "not a regular file";
    if (status.st_size == 0) return {}; // also what the system makes up (/proc): reading may wait, or find no end
    const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) return textOf(errno);
    char buffer[4096];
    while (const size_t count = std::fread(buffer, 1, sizeof buffer, file.get())) {
        out.append(buffer, count);
        if (out.size() > mostBytes) return "larger than " + std::to_string(mostBytes) + " bytes";
    }
    return std::ferror(file.get()) ? textOf(errno) : std::string();
}

std::string whyNoFile(const std::string &path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return "no such file";
    return S_ISREG(status.st_mode) ? "" : "not a file";
}

bool listFolder(const std::string &folder, std::vector<std::string> &names) {
    const std::unique_ptr<DIR, int (*)(DIR *)> entries(opendir(folder.c_str()), closedir);
    if (!entries) return false;
    for (;;) {
        errno = 0;
        const dirent *entry = readdir(entries.get());
        if (!entry) return errno == 0;
        names.emplace_back(entry->d_name);
    }
}

std::string ownFolder() {
    Dl_info info{};
    static const char here = 0;
    if (!dladdr(&here, &info) || !info.dli_fname) return {};
    // A program that was found through PATH is known by its bare name only.
    const bool isBareName = !std::strchr(info.dli_fname, '/');
    const std::unique_ptr<char, void (*)(void *)> file(
        realpath(isBareName ? "/proc/self/exe" : info.dli_fname, nullptr), std::free);
    if (!file) return {};
    const std::string path = file.get();
    return path.substr(0, path.rfind('/'));
}

double stringToDouble(const char *text, char **end) {
    const EnglishHere english;
    return std::strtod(text, end);
}

// dlopen would look for a name without a slash in the system's folders.
SharedObject::SharedObject(const std::string &path) {
    const EnglishHere english;
    m_handle = dlopen((path.find('/') == path.npos ? "./" + path : path).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (m_handle) return;
    const char *reason = dlerror();
    m_reason = reason ? reason : "unknown";
}

SharedObject::~SharedObject() {
    if (m_handle) dlclose(m_handle);
}

const void *SharedObject::symbol(const char *name) const { return dlsym(m_handle, name); }

} // namespace phys::system
