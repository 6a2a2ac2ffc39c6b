// SPDX-License-Identifier: MIT
// Appendable structs across versions. A caller compiled against an older header passes fewer bytes than the present
// struct has: members it lacks have the values of the *_init function, and are never written to. A larger size is
// refused, because members of a newer header may have a meaning.
#pragma once

#include <physics/plugin.h>

#include <cstddef>
#include <cstring>

namespace phys {

/// Size in bytes of the first version of each appendable struct in ABI 1: up to its last member then.
template<class T>
inline constexpr uint32_t kFirstSize = 0;
#define PHYS_LAST_OF_FIRST_VERSION(type, member)                                                                       \
    template<>                                                                                                         \
    inline constexpr uint32_t kFirstSize<type> = (offsetof(type, member) + sizeof(type::member))
PHYS_LAST_OF_FIRST_VERSION(phys_scene_desc, start);
PHYS_LAST_OF_FIRST_VERSION(phys_params, stepper);
PHYS_LAST_OF_FIRST_VERSION(phys_report, energy_scheme);
PHYS_LAST_OF_FIRST_VERSION(phys_batch, statuses);
PHYS_LAST_OF_FIRST_VERSION(phys_stepper_api, extension);
PHYS_LAST_OF_FIRST_VERSION(phys_plugin, steppers);
#undef PHYS_LAST_OF_FIRST_VERSION

/// Whether a struct of this size is of this version or an older one.
template<class T>
constexpr bool isKnownSize(size_t size) {
    return size >= kFirstSize<T> && size <= sizeof(T);
}

/// Whether it is of an older version. While there is only one version, this is constant false.
template<class T>
constexpr bool isOlder(const T &given) {
    return isKnownSize<T>(given.struct_size) && given.struct_size < sizeof(T);
}

/// The first `size` bytes of `whole`, and that size: for a struct of a caller of any version.
template<class T>
void store(T whole, size_t size, T *out) {
    whole.struct_size = static_cast<uint32_t>(size);
    std::memcpy(static_cast<void *>(out), &whole, size);
}

/// An older struct converted to the present size; init: its *_init function.
template<class T>
T completed(const T &older, phys_status (*init)(T *, size_t)) {
    T whole;
    init(&whole, sizeof whole);
    std::memcpy(static_cast<void *>(&whole), &older, older.struct_size);
    whole.struct_size = sizeof whole;
    return whole;
}

} // namespace phys
