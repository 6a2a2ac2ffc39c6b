// SPDX-License-Identifier: MIT
// From a file to steppers in the registry: open it, find the table, check it, and only then register it.
#include "base/error.h"
#include "base/system.h"
#include "registry/plugin_check.h"
#include "registry/registry.h"
#include "registry/shared_object_file.h"

#include <algorithm>
#include <memory>
#include <new>

namespace phys {

namespace {

constexpr const char *kSearchVariable = "PHYS_PLUGIN_PATH";
constexpr const char *kFolderBesideLibrary = "physics-1"; // 1: PHYS_ABI_VERSION

/// The plugins' names in a folder, sorted. False if the folder can't be read.
bool listPlugins(const std::string &folder, std::vector<std::string> &names) {
    if (!system::listFolder(folder, names)) return false;
    const std::string_view suffix = system::kObjectSuffix;
    std::erase_if(names,
                  [&](const std::string &name) { return name.size() <= suffix.size() || !name.ends_with(suffix); });
    std::sort(names.begin(), names.end());
    return true;
}

void add(phys_registry &registry, const phys_plugin &plugin, const std::string &path) {
    const auto file = std::make_shared<const std::string>(path);
    std::vector<PluginStepper> steppers = registry.plugins;
    for (uint32_t i = 0; i < plugin.stepper_count; ++i) steppers.push_back({plugin.steppers[i], file});
    registry.plugins.swap(steppers); // either all of them or none
}

phys_status loadFile(phys_registry &registry, const std::string &path, phys_error *err) {
    if (path.empty()) return fail(err, PHYS_ERROR_FILE, "path is empty; expected a file's name");
    const auto isItsFile = [&](const PluginStepper &stepper) { return *stepper.file == path; };
    if (std::ranges::any_of(registry.plugins, isItsFile))
        return failIn(err, PHYS_ERROR_PLUGIN_REFUSED, path, ": is loaded already");
    if (const phys_status status = checkSharedObjectFile(path, err)) return status;
    system::SharedObject object(path);
    if (!object.isOpen()) {
        return failIn(err, PHYS_ERROR_PLUGIN_REFUSED, path, ": expected a shared object that loads; found: %s",
                      object.reason().c_str());
    }
    const auto *plugin = static_cast<const phys_plugin *>(object.symbol("phys_plugin_entry"));
    if (!plugin) {
        return failIn(err, PHYS_ERROR_PLUGIN_REFUSED, path, ": expected the symbol phys_plugin_entry; found none");
    }
    if (isOfDeletedFile(plugin)) {
        return failIn(err, PHYS_ERROR_PLUGIN_REFUSED, path,
                      ": this process has loaded an older file of this name and keeps its code; give the new one "
                      "another name, or load it in another process");
    }
    if (const phys_status status = checkPlugin(*plugin, path, registry, err)) return status;
    add(registry, *plugin, path);
    object.keep(); // its texts and code are in use from now on
    return PHYS_OK;
}

/// The data of a scan: the registry for the plugins (NULL: they are only listed), and the callback for each file.
struct Scan {
    phys_registry *registry;
    phys_scan_function report;
    void *context;

    void tell(const std::string &path, phys_status status, const std::string &text) const {
        if (report) report(context, path.c_str(), status, text.c_str());
    }

    void loadOne(const std::string &path) const {
        if (!registry) return tell(path, PHYS_OK, "");
        const size_t before = registry->plugins.size();
        phys_error error{};
        if (const phys_status status = loadFile(*registry, path, &error)) return tell(path, status, error.text);
        std::string ids = "loaded";
        for (size_t i = before; i < registry->plugins.size(); ++i) {
            ids += (i > before ? ", " : " ") + std::string(registry->plugins[i].api->id);
        }
        tell(path, PHYS_OK, ids);
    }

    /// False if the folder can't be read.
    bool loadFolder(const std::string &folder) const {
        std::vector<std::string> names;
        if (!listPlugins(folder, names)) return false;
        const std::string prefix = folder.ends_with('/') ? folder : folder + '/';
        for (const std::string &name : names) loadOne(prefix + name);
        return true;
    }

    void loadSearchPath(const std::string &list) const {
        for (size_t begin = 0; begin <= list.size();) {
            const size_t end = std::min(list.find(system::kPathSeparator, begin), list.size());
            const std::string folder = list.substr(begin, end - begin);
            begin = end + 1;
            if (folder.empty() || loadFolder(folder)) continue;
            phys_error error{};
            failIn(&error, PHYS_ERROR_FILE, folder, ": a folder of %s that can't be read", kSearchVariable);
            tell(folder, error.status, error.text);
        }
    }
};

phys_status scan(const Scan &scan, const char *folder, phys_error *err) {
    if (folder) {
        if (!*folder) return fail(err, PHYS_ERROR_FILE, "folder is empty; expected a folder's name");
        if (scan.loadFolder(folder)) return PHYS_OK;
        return failIn(err, PHYS_ERROR_FILE, folder, ": expected a folder that can be read");
    }
    scan.loadSearchPath(system::environmentVariable(kSearchVariable));
    const std::string own = system::ownFolder();
    if (!own.empty()) scan.loadFolder(own + '/' + kFolderBesideLibrary); // this folder may be missing
    return PHYS_OK;
}

} // namespace

} // namespace phys

phys_status phys_registry_load_file(phys_registry *registry, const char *path, phys_error *err) try {
    if (!registry || !path) {
        return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL", registry ? "path" : "registry");
    }
    return phys::loadFile(*registry, path, err);
} catch (const std::bad_alloc &) {
    return phys::fail(err, PHYS_ERROR_MEMORY, "out of memory for a plugin");
} catch (...) {
    return phys::fail(err, PHYS_ERROR_INTERNAL, "an exception while a plugin was loaded");
}

phys_status phys_registry_scan(phys_registry *registry, const char *folder, phys_scan_function report, void *context,
                               phys_error *err) try {
    return phys::scan({registry, report, context}, folder, err);
} catch (const std::bad_alloc &) {
    return phys::fail(err, PHYS_ERROR_MEMORY, "out of memory for a plugin");
} catch (...) {
    return phys::fail(err, PHYS_ERROR_INTERNAL, "an exception while plugins were scanned");
}
