// SPDX-License-Identifier: MIT
// Any numbers, texts and NULLs in a plugin's table: accepted, or refused with one line, before any of its functions is
// called.
#include "input.h"

#include "registry/plugin_check.h"

#include <string>
#include <vector>

namespace {

/// A text or NULL; the buffer ends right after the text's NUL, so that reading beyond it is detected.
class Text {
public:
    explicit Text(fuzz::Input &input) {
        const auto length = input.take<uint8_t>();
        if (length == 255) return;
        m_bytes.resize(length % 140 + 1);
        for (size_t i = 0; i + 1 < m_bytes.size(); ++i) {
            const char c = input.take<char>();
            m_bytes[i] = c ? c : 'a';
        }
    }
    const char *get() const { return m_bytes.empty() ? nullptr : m_bytes.data(); }

private:
    std::vector<char> m_bytes;
};

struct Row {
    explicit Row(fuzz::Input &input)
        : id(input)
        , label(input)
        , unit(input)
        , help(input)
        , choices(input)
        , row{id.get(), label.get(), unit.get(), help.get(), choices.get(), 0, 0, 0, 0, 0, 0, 0, 0} {
        row.min = input.number();
        row.max = input.number();
        row.low = input.number();
        row.high = input.number();
        row.initial = input.number();
        row.step = input.number();
        row.offset = 80 + input.take<uint8_t>();
        row.flags = input.take<uint8_t>() % 16;
    }
    Text id, label, unit, help, choices;
    phys_param_row row;
};

[[noreturn]] void trap() { __builtin_trap(); } // none of a table's functions may be called
phys_status create(const phys_scene_view *, void **, phys_error *) { trap(); }
void destroy(void *) { trap(); }
phys_status step(void *, const phys_params *, double, const phys_state *, phys_state *, phys_report *, phys_error *) {
    trap();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz::Input input(data, size);
    const Text id(input);
    const Text name(input);
    const Text version(input);
    const Text summary(input);
    const Row first(input);
    const Row second(input);
    const phys_param_row *const rows[] = {&first.row, input.take<uint8_t>() == 255 ? nullptr : &second.row};
    phys_stepper_api api{};
    api.struct_size = input.take<uint8_t>();
    api.flags = input.take<uint8_t>() % 8;
    api.id = id.get();
    api.name = name.get();
    api.version = version.get();
    api.summary = summary.get();
    api.rows = input.take<uint8_t>() == 255 ? nullptr : rows;
    api.row_count = input.take<uint8_t>() % 3;
    const auto missing = input.take<uint8_t>();
    api.create = missing == 1 ? nullptr : create;
    api.destroy = missing == 2 ? nullptr : destroy;
    api.step = missing == 3 ? nullptr : step;
    const phys_stepper_api *const steppers[] = {&api, missing == 4 ? nullptr : &api};
    const phys_plugin plugin{input.take<uint8_t>(), input.take<uint8_t>(), input.take<uint8_t>() % 3U, 0,
                             missing == 5 ? nullptr : steppers};

    const phys_registry registry;
    phys_error error{};
    const phys_status status = phys::checkPlugin(plugin, "fuzzed.so", registry, &error);
    if (status) fuzz::demand(error.status == PHYS_ERROR_PLUGIN_REFUSED && !std::strncmp(error.text, "fuzzed.so: ", 11));
    return 0;
}
