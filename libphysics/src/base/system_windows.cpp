// SPDX-License-Identifier: MIT
#include "base/system.h"

#include <cstdlib>
#include <locale.h>
#include <memory>
#include <type_traits>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

namespace phys::system {

namespace {

std::wstring wide(const std::string &text) {
    const int size = static_cast<int>(text.size());
    std::wstring result(static_cast<size_t>(MultiByteToWideChar(CP_UTF8, 0, text.data(), size, nullptr, 0)), L'\0');
    MultiByteToWideChar(CP_UTF8, 0, text.data(), size, result.data(), static_cast<int>(result.size()));
    return result;
}

std::string narrow(const wchar_t *text) {
    const int size = WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
    std::string result(static_cast<size_t>(size > 0 ? size : 1), '\0');
    WideCharToMultiByte(CP_UTF8, 0, text, -1, result.data(), size, nullptr, nullptr);
    result.pop_back(); // the NUL
    return result;
}

/// The system's message in English, without its localised catalogues.
std::string textOf(DWORD error) {
    switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
        return "No such file or directory";
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
        return "Permission denied";
    case ERROR_BAD_EXE_FORMAT:
        return "not a DLL for this processor";
    case ERROR_MOD_NOT_FOUND:
        return "a DLL that it needs isn't found";
    case ERROR_PROC_NOT_FOUND:
        return "a function that it needs isn't found";
    default:
        return "Windows error " + std::to_string(error);
    }
}

struct HandleCloser {
    void operator()(HANDLE handle) const { CloseHandle(handle); }
};
using Handle = std::unique_ptr<std::remove_pointer_t<HANDLE>, HandleCloser>;

} // namespace

const char kPathSeparator = ';';
const char *const kObjectSuffix = ".dll";

std::string environmentVariable(const char *name) {
    const wchar_t *value = _wgetenv(wide(name).c_str());
    return value ? narrow(value) : "";
}

std::string readFile(const std::string &path, size_t mostBytes, std::string &out) {
    const HANDLE opened = CreateFileW(wide(path).c_str(), GENERIC_READ, FILE_SHARE_READ, nullptr, OPEN_EXISTING,
                                      FILE_ATTRIBUTE_NORMAL, nullptr);
    if (opened == INVALID_HANDLE_VALUE) return textOf(GetLastError());
    const Handle file(opened);
    if (GetFileType(opened) != FILE_TYPE_DISK) return "not a regular file";
    char buffer[4096];
    for (DWORD count = 0;;) {
        if (!ReadFile(file.get(), buffer, sizeof buffer, &count, nullptr)) return textOf(GetLastError());
        if (count == 0) return {};
        out.append(buffer, count);
        if (out.size() > mostBytes) return "larger than " + std::to_string(mostBytes) + " bytes";
    }
}

std::string whyNoFile(const std::string &path) {
    const DWORD attributes = GetFileAttributesW(wide(path).c_str());
    if (attributes == INVALID_FILE_ATTRIBUTES) return "no such file";
    return attributes & FILE_ATTRIBUTE_DIRECTORY ? "not a file" : "";
}

bool listFolder(const std::string &folder, std::vector<std::string> &names) {
    WIN32_FIND_DATAW entry;
    const HANDLE search = FindFirstFileW(wide(folder + "\\*").c_str(), &entry);
    if (search == INVALID_HANDLE_VALUE) return false;
    const std::unique_ptr<void, BOOL (*)(HANDLE)> closer(search, [](HANDLE handle) { return FindClose(handle); });
    do names.push_back(narrow(entry.cFileName));
    while (FindNextFileW(search, &entry));
    return true;
}

std::string ownFolder() {
    static const char here = 0;
    HMODULE module = nullptr;
    constexpr DWORD kByAddress = GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
    if (!GetModuleHandleExW(kByAddress, reinterpret_cast<LPCWSTR>(&here), &module)) return {};
    std::wstring path(MAX_PATH, L'\0');
    for (;;) {
        const DWORD length = GetModuleFileNameW(module, path.data(), static_cast<DWORD>(path.size()));
        if (length == 0) return {};
        if (length < path.size()) {
            const std::string file = narrow(path.c_str());
            return file.substr(0, file.find_last_of("\\/"));
        }
        path.resize(2 * path.size());
    }
}

double stringToDouble(const char *text, char **end) {
    static const _locale_t plain = _create_locale(LC_ALL, "C");
    return _strtod_l(text, end, plain);
}

/// The path as LoadLibraryW needs it: absolute, so that no other folder is searched, with backslashes.
SharedObject::SharedObject(const std::string &path) {
    const std::wstring given = wide(path);
    std::wstring whole(GetFullPathNameW(given.c_str(), 0, nullptr, nullptr), L'\0');
    if (!whole.empty()) GetFullPathNameW(given.c_str(), static_cast<DWORD>(whole.size()), whole.data(), nullptr);
    const UINT before = SetErrorMode(SEM_FAILCRITICALERRORS); // no dialog on the screen
    m_handle = reinterpret_cast<void *>(LoadLibraryW(whole.c_str()));
    if (!m_handle) m_reason = textOf(GetLastError());
    SetErrorMode(before);
}

SharedObject::~SharedObject() {
    if (m_handle) FreeLibrary(static_cast<HMODULE>(m_handle));
}

const void *SharedObject::symbol(const char *name) const {
    return reinterpret_cast<const void *>(GetProcAddress(static_cast<HMODULE>(m_handle), name));
}

} // namespace phys::system
