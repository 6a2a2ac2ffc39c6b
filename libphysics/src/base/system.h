// SPDX-License-Identifier: MIT
// Differences between operating systems, behind one interface: system_posix.cpp, system_windows.cpp. Paths are UTF-8.
// Nothing depends on the locale, and running out of memory throws std::bad_alloc, whereas std::filesystem's functions
// with an error_code would end the process.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace phys::system {

extern const char kPathSeparator;       ///< between the folders of a search path
extern const char *const kObjectSuffix; ///< of the names of shared objects

/// Empty if the variable isn't set.
std::string environmentVariable(const char *name);

/// Appends the content of a regular file (a pipe or a device might never end). On failure returns the reason in words.
std::string readFile(const std::string &path, size_t mostBytes, std::string &out);

/// Why a path isn't that of a file, in words; empty if it is.
std::string whyNoFile(const std::string &path);

/// The names in a folder, in no particular order. False if it can't be read.
bool listFolder(const std::string &folder, std::vector<std::string> &names);

/// The folder of the library or program that this code was loaded from, without a slash at its end; empty if unknown.
std::string ownFolder();

/// As strtod in the C locale.
double stringToDouble(const char *text, char **end);

/// A shared object that is closed on destruction unless it is kept.
class SharedObject {
public:
    explicit SharedObject(const std::string &path);
    ~SharedObject();
    SharedObject(const SharedObject &) = delete;
    SharedObject &operator=(const SharedObject &) = delete;

    bool isOpen() const { return m_handle != nullptr; }
    const std::string &reason() const { return m_reason; } ///< why it isn't open
    const void *symbol(const char *name) const;
    void keep() { m_handle = nullptr; } ///< it stays loaded until the process ends

private:
    void *m_handle;
    std::string m_reason;
};

} // namespace phys::system
