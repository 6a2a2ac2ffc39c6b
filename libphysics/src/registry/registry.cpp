// SPDX-License-Identifier: MIT
#include "registry/registry.h"

#include "base/appendable.h"
#include "base/error.h"
#include "base/text.h"
#include "registry/built_in_steppers.h"
#include "registry/params.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace phys {

namespace {

uint32_t builtInCount() { return static_cast<uint32_t>(std::size(kBuiltIn)); }

/// index below phys_registry_count(registry).
phys_stepper_info describe(const phys_registry *registry, uint32_t index) {
    const bool isPlugin = index >= builtInCount();
    const PluginStepper *plugin = isPlugin ? &registry->plugins[index - builtInCount()] : nullptr;
    const phys_stepper_api &api = isPlugin ? *plugin->api : *kBuiltIn[index];
    return {api.id,
            api.name,
            api.version,
            api.summary,
            isPlugin ? plugin->file->c_str() : "",
            api.rows,
            api.row_count,
            api.flags | (isPlugin ? static_cast<uint32_t>(PHYS_STEPPER_PLUGIN) : 0U)};
}

/// Names all ids, as many as there is room for; allocates nothing.
phys_status refuseUnknown(const phys_registry *registry, const char *id, phys_error *err) {
    char ids[sizeof phys_error::text] = "";
    for (uint32_t i = 0; i < phys_registry_count(registry); ++i) {
        const size_t length = std::strlen(ids);
        writeText(ids + length, sizeof ids - length, "%s%s", i ? ", " : "", describe(registry, i).id);
    }
    return fail(err, PHYS_ERROR_UNKNOWN_STEPPER, "no stepper has the id '%.60s'; known are %s", id, ids);
}

/// Whether its rows can be those of a stepper: infos may be made by hand.
bool hasOwnRows(const phys_stepper_info &info) {
    if (info.row_count > PHYS_STEPPER_VALUES || (info.row_count > 0 && !info.rows)) return false;
    return std::all_of(info.rows, info.rows + info.row_count,
                       [](const phys_param_row *row) { return row && isOwnPlace(row->offset); });
}

} // namespace

FoundStepper findStepper(const phys_registry *registry, const char *id) {
    for (const phys_stepper_api *api : kBuiltIn) {
        if (std::strcmp(api->id, id) == 0) return {api, false};
    }
    if (!registry) return {nullptr, false};
    for (const PluginStepper &plugin : registry->plugins) {
        if (std::strcmp(plugin.api->id, id) == 0) return {plugin.api, true};
    }
    return {nullptr, false};
}

} // namespace phys

phys_status phys_registry_create(phys_registry **out, phys_error *err) {
    if (!out) return phys::fail(err, PHYS_ERROR_ARGUMENT, "out is NULL");
    auto *registry = new (std::nothrow) phys_registry;
    if (!registry) return phys::fail(err, PHYS_ERROR_MEMORY, "out of memory for a registry");
    *out = registry;
    return PHYS_OK;
}

void phys_registry_destroy(phys_registry *registry) { delete registry; }

uint32_t phys_registry_count(const phys_registry *registry) {
    const size_t plugins = registry ? registry->plugins.size() : 0;
    return phys::builtInCount() + static_cast<uint32_t>(plugins);
}

phys_status phys_registry_info(const phys_registry *registry, uint32_t index, phys_stepper_info *out) {
    if (!out || index >= phys_registry_count(registry)) return PHYS_ERROR_ARGUMENT;
    *out = phys::describe(registry, index);
    return PHYS_OK;
}

phys_status phys_registry_find(const phys_registry *registry, const char *id, phys_stepper_info *out, phys_error *err) {
    if (!id || !out) return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL", id ? "out" : "id");
    for (uint32_t i = 0; i < phys_registry_count(registry); ++i) {
        const phys_stepper_info info = phys::describe(registry, i);
        if (std::strcmp(info.id, id) != 0) continue;
        *out = info;
        return PHYS_OK;
    }
    return phys::refuseUnknown(registry, id, err);
}

phys_status phys_stepper_info_init_params(const phys_stepper_info *info, phys_params *params) {
    if (!info || !params || !phys::isKnownSize<phys_params>(params->struct_size)) return PHYS_ERROR_ARGUMENT;
    if (!phys::hasOwnRows(*info)) return PHYS_ERROR_ARGUMENT;
    phys_params filled{};
    std::memcpy(&filled, params, params->struct_size);
    std::memset(filled.stepper, 0, sizeof filled.stepper);
    for (uint32_t i = 0; i < info->row_count; ++i) {
        if (const phys_status status = phys_param_set(&filled, info->rows[i], info->rows[i]->initial, nullptr)) {
            return status;
        }
    }
    phys::store(filled, params->struct_size, params);
    return PHYS_OK;
}
