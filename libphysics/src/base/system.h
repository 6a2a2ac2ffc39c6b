// SPDX-License-Identifier: MIT
// What differs between operating systems, behind one interface: system_posix.cpp, system_windows.cpp. Paths are UTF-8.
// Nothing here depends on the locale, and memory that runs out is std::bad_alloc: the functions of std::filesystem that
// take an error_code end the process instead.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace phys::system {

extern const char kPathSeparator;       ///< between the folders of a search path
extern const char *const kObjectSuffix; ///< of the names of shared objects

/// Empty if it isn't set.
std::string environmentVariable(const char *name);

/// Appends the content of a regular file (a pipe or a device might never end); on failure returns why, in words.
std::string readFile(const std::string &path, size_t mostBytes, std::string &out);

/// Why a path isn't that of a file, in words; empty if it is one.
std::string whyNoFile(const std::string &path);

/// The names in a folder, in no order. False if it can't be read.
bool listFolder(const std::string &folder, std::vector<std::string> &names);

/// The folder of the library or program that this code was loaded from, without a slash at its end; empty if unknown.
std::string ownFolder();

/// As strtod in the C locale.
double stringToDouble(const char *text, char **end);

/// A shared object that is closed again unless it is kept.
class SharedObject {
public:
    explicit SharedObject(const std::string &path);
    ~SharedObject();
    SharedObject(const SharedObject &) = delete;
    SharedObject &operator=(const SharedObject &) = delete;

    bool isOpen() const { return m_handle != nullptr; }
    const std::string &reason() const { return m_reason; } ///< why it isn't open
    const void *symbol(const char *name) const;
    void keep() { m_handle = nullptr; } ///< loaded until the process ends

private:
    void *m_handle;
    std::string m_reason;
};

} // namespace phys::system
