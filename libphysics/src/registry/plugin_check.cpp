// SPDX-License-Identifier: MIT
#include "registry/plugin_check.h"

#include "base/appendable.h"
#include "base/error.h"
#include "base/utf8.h"
#include "registry/params.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>

namespace phys {

namespace {

constexpr uint32_t kMostSteppers = 256;
constexpr uint32_t kStepperFlags = PHYS_STEPPER_EXACT_IN_DT | PHYS_STEPPER_BITS_EVERYWHERE;
constexpr uint32_t kRowFlags = PHYS_ROW_CHOICE | PHYS_ROW_RIGID | PHYS_ROW_SWITCH;

/// Names that programs use for options and columns of their own: plugin.h.
constexpr const char *kReservedIds[] = {PHYS_RESERVED_ROW_IDS};

struct Length {
    size_t least, most; // bytes, both included
};
constexpr Length kIdLength{1, 63};

bool isLowerOrDigit(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

/// Checks one plugin. Every check ends in `refuse` or PHYS_OK; m_where names the part that is being checked.
class PluginCheck {
public:
    PluginCheck(const phys_plugin &plugin, const std::string &file, const phys_registry &registry, phys_error *err)
        : m_plugin(plugin)
        , m_file(file)
        , m_registry(registry)
        , m_err(err) {}

    phys_status run() {
        if (m_plugin.abi_version != PHYS_ABI_VERSION) {
            return refuse("abi_version is %u; expected %u", m_plugin.abi_version, PHYS_ABI_VERSION);
        }
        if (const phys_status status = checkSize<phys_plugin>(m_plugin.struct_size)) return status;
        if (m_plugin.reserved != 0) return refuse("reserved is %u; expected 0", m_plugin.reserved);
        if (m_plugin.stepper_count < 1 || m_plugin.stepper_count > kMostSteppers) {
            return refuse("stepper_count is %u; expected 1 .. %u", m_plugin.stepper_count, kMostSteppers);
        }
        if (!m_plugin.steppers) {
            return refuse("steppers is NULL; expected %u pointers to tables", m_plugin.stepper_count);
        }
        for (uint32_t i = 0; i < m_plugin.stepper_count; ++i) {
            m_where = "stepper " + std::to_string(i) + ": ";
            const phys_stepper_api *api = m_plugin.steppers[i];
            if (!api) return refuse("the pointer is NULL; expected a table");
            if (const phys_status status = checkStepper(*api, i)) return status;
        }
        return PHYS_OK;
    }

private:
    [[PHYS_CHECKED_FORMAT(2, 3)]] phys_status refuse(const char *format, ...) {
        char reason[sizeof(phys_error::text)];
        va_list arguments;
        va_start(arguments, format);
        writeTextOf(reason, sizeof reason, format, arguments);
        va_end(arguments);
        return failIn(m_err, PHYS_ERROR_PLUGIN_REFUSED, m_file, ": %s%s", m_where.c_str(), reason);
    }

    /// A longer table belongs to a later version, whose additional members would be ignored.
    template<class Table>
    phys_status checkSize(uint32_t size) {
        if (isKnownSize<Table>(size)) return PHYS_OK;
        return refuse("struct_size is %u; expected %u .. %zu", size, kFirstSize<Table>, sizeof(Table));
    }

    phys_status checkStepper(const phys_stepper_api &api, uint32_t index) {
        if (const phys_status status = checkSize<phys_stepper_api>(api.struct_size)) return status;
        if (const phys_status status = checkText("id", api.id, kIdLength)) return status;
        if (const phys_status status = checkId("id", api.id, '-')) return status;
        m_where = "stepper '" + std::string(api.id) + "': ";
        if (const phys_status status = checkText("name", api.name, {1, 127})) return status;
        if (const phys_status status = checkText("version", api.version, {1, 31})) return status;
        if (const phys_status status = checkText("summary", api.summary, {0, 255})) return status;
        if (const phys_status status = checkUnique(api, index)) return status;
        if (const uint32_t unknown = api.flags & ~kStepperFlags) {
            return refuse("flags has the unknown bits 0x%x; known bits are 0x%x", unknown, kStepperFlags);
        }
        if (api.reserved != 0) return refuse("reserved is %u; expected 0", api.reserved);
        if (const char *missing = missingFunction(api)) return refuse("%s is NULL; expected a function", missing);
        return checkRows(api);
    }

    static const char *missingFunction(const phys_stepper_api &api) {
        if (!api.create) return "create";
        if (!api.destroy) return "destroy";
        return api.step ? nullptr : "step";
    }

    /// A text of one line, which people and programs read in lists.
    phys_status checkText(const char *member, const char *text, Length length) {
        if (const phys_status status = checkLength(member, text, length)) return status;
        return checkLine(member, text);
    }

    phys_status checkLength(const char *member, const char *text, Length length) {
        if (!text) return refuse("%s is NULL; expected a text", member);
        const size_t found = strnlen(text, length.most + 1);
        if (found > length.most) return refuse("%s has over %zu bytes; that is the most", member, length.most);
        if (found < length.least) return refuse("%s is empty; expected a text", member);
        return PHYS_OK;
    }

    phys_status checkLine(const char *member, std::string_view line) {
        while (!line.empty()) {
            const size_t bytes = firstCharacter(line).bytes;
            if (bytes == 0) {
                return refuse("%s has the byte 0x%02x; expected one line of UTF-8 without control characters", member,
                              static_cast<unsigned>(static_cast<unsigned char>(line.front())));
            }
            line.remove_prefix(bytes);
        }
        return PHYS_OK;
    }

    phys_status checkId(const char *member, const char *id, char separator) {
        for (const char *c = id; *c; ++c) {
            if (isLowerOrDigit(*c) || *c == separator) continue;
            return refuse("%s has the byte 0x%02x; expected lower case letters, digits and '%c'", member,
                          static_cast<unsigned>(static_cast<unsigned char>(*c)), separator);
        }
        return PHYS_OK;
    }

    /// index: of api in the plugin's list.
    phys_status checkUnique(const phys_stepper_api &api, uint32_t index) {
        for (uint32_t i = 0; i < index; ++i) {
            if (std::strcmp(m_plugin.steppers[i]->id, api.id) == 0) {
                return refuse("the id is that of stepper %u of this plugin too; expected a unique one", i);
            }
        }
        phys_stepper_info other;
        if (phys_registry_find(&m_registry, api.id, &other, nullptr)) return PHYS_OK;
        return refuse("the id is taken by %s; expected a unique one",
                      other.file[0] ? other.file : "a built-in stepper");
    }

    phys_status checkRows(const phys_stepper_api &api) {
        if (api.row_count > PHYS_STEPPER_VALUES) {
            return refuse("row_count is %u; expected at most %u", api.row_count, PHYS_STEPPER_VALUES);
        }
        if (api.row_count > 0 && !api.rows) return refuse("rows is NULL; expected %u pointers", api.row_count);
        const std::string stepper = m_where;
        for (uint32_t i = 0; i < api.row_count; ++i) {
            m_where = stepper + "row " + std::to_string(i) + ": ";
            if (!api.rows[i]) return refuse("the pointer is NULL; expected a row");
            const phys_param_row &row = *api.rows[i];
            if (const phys_status status = checkRowTexts(row)) return status;
            m_where = stepper + "row '" + row.id + "': ";
            if (const phys_status status = checkRowUnique(api, i)) return status;
            if (const phys_status status = checkRowPlace(row)) return status;
            if (const phys_status status = checkRowNumbers(row)) return status;
            if (const phys_status status = checkRowKind(row)) return status;
        }
        return PHYS_OK;
    }

    phys_status checkRowTexts(const phys_param_row &row) {
        if (const phys_status status = checkText("id", row.id, kIdLength)) return status;
        if (const phys_status status = checkId("id", row.id, '_')) return status;
        if (const phys_status status = checkText("label", row.label, {1, 63})) return status;
        if (const phys_status status = checkText("unit", row.unit, {0, 15})) return status;
        if (const phys_status status = checkText("help", row.help, {0, 511})) return status;
        return checkChoices(row);
    }

    phys_status checkChoices(const phys_param_row &row) {
        if (const phys_status status = checkLength("choices", row.choices, {0, 511})) return status;
        const std::string_view choices = row.choices;
        if (choices.empty()) return PHYS_OK;
        if (!(row.flags & PHYS_ROW_CHOICE)) {
            return refuse("choices is '%s' though flags don't say choice; expected \"\"", row.choices);
        }
        for (size_t begin = 0; begin <= choices.size();) {
            const size_t end = std::min(choices.find('\n', begin), choices.size());
            if (begin == end) return refuse("choices has an empty name; expected names separated by \\n");
            if (const phys_status status = checkLine("choices", choices.substr(begin, end - begin))) return status;
            begin = end + 1;
        }
        return PHYS_OK;
    }

    /// Ids become names of settings, options and columns, so they must differ from the library's and from each other;
    /// so must positions.
    phys_status checkRowUnique(const phys_stepper_api &api, uint32_t index) {
        const phys_param_row &row = *api.rows[index];
        for (const char *reserved : kReservedIds) {
            if (std::strcmp(reserved, row.id) == 0) return refuse("the id is reserved; expected another");
        }
        uint32_t count = 0;
        const phys_param_row *own = phys_param_rows(&count);
        for (uint32_t i = 0; i < count; ++i) {
            if (std::strcmp(own[i].id, row.id) == 0)
                return refuse("the library has a row of this id; expected another");
        }
        for (uint32_t i = 0; i < index; ++i) {
            if (std::strcmp(api.rows[i]->id, row.id) == 0) return refuse("row %u has this id too; expected another", i);
            if (api.rows[i]->offset == row.offset)
                return refuse("row %u has the offset %u too; expected another", i, row.offset);
        }
        return PHYS_OK;
    }

    phys_status checkRowPlace(const phys_param_row &row) {
        constexpr auto kFirst = static_cast<uint32_t>(offsetof(phys_params, stepper));
        constexpr auto kLast = static_cast<uint32_t>(kFirst + (PHYS_STEPPER_VALUES - 1) * sizeof(double));
        if (isOwnPlace(row.offset)) return PHYS_OK;
        return refuse("offset is %u; expected %u .. %u in steps of %zu: an element of phys_params.stepper", row.offset,
                      kFirst, kLast, sizeof(double));
    }

    phys_status checkRowNumbers(const phys_param_row &row) {
        const struct {
            const char *name;
            double value;
        } numbers[] = {{"min", row.min},   {"low", row.low}, {"initial", row.initial},
                       {"high", row.high}, {"max", row.max}, {"step", row.step}};
        for (const auto &number : numbers) {
            if (!std::isfinite(number.value))
                return refuse("%s is %g; expected a finite number", number.name, number.value);
        }
        for (size_t i = 0; i + 2 < std::size(numbers); ++i) { // all except the last, which is step
            if (numbers[i].value <= numbers[i + 1].value) continue;
            return refuse("%s is %.17g and %s is %.17g; expected min <= low <= initial <= high <= max", numbers[i].name,
                          numbers[i].value, numbers[i + 1].name, numbers[i + 1].value);
        }
        if (!(row.low < row.high)) return refuse("low and high are both %.17g; expected a range", row.low);
        if (!(row.step > 0.0)) return refuse("step is %.17g; expected a number above 0", row.step);
        return PHYS_OK;
    }

    phys_status checkRowKind(const phys_param_row &row) {
        if (const uint32_t unknown = row.flags & ~kRowFlags) {
            return refuse("flags has the bits 0x%x; allowed bits are 0x%x", unknown, kRowFlags);
        }
        const bool isChoice = row.flags & PHYS_ROW_CHOICE;
        const bool isSwitch = row.flags & PHYS_ROW_SWITCH;
        if (isChoice && isSwitch) return refuse("flags say both choice and switch; expected one of them");
        const bool isWhole = row.initial == std::floor(row.initial);
        if (isSwitch && !(row.min == 0.0 && row.max == 1.0 && isWhole)) {
            return refuse("a switch has min %.17g, initial %.17g, max %.17g; expected 0, 0 or 1, 1", row.min,
                          row.initial, row.max);
        }
        return isChoice ? checkChoice(row) : PHYS_OK;
    }

    phys_status checkChoice(const phys_param_row &row) {
        double names = row.choices[0] ? 1.0 : 0.0;
        for (const char *c = row.choices; *c; ++c) names += *c == '\n' ? 1.0 : 0.0;
        if (row.min != 0.0 || row.max != names - 1.0 || row.initial != std::floor(row.initial)) {
            return refuse(
                "a choice of %g names has min %.17g, initial %.17g, max %.17g; expected whole numbers from 0 to "
                "one less than names",
                names, row.min, row.initial, row.max);
        }
        return PHYS_OK;
    }

    const phys_plugin &m_plugin;
    const std::string &m_file;
    const phys_registry &m_registry;
    phys_error *m_err;
    std::string m_where;
};

} // namespace

phys_status checkPlugin(const phys_plugin &plugin, const std::string &file, const phys_registry &registry,
                        phys_error *err) {
    return PluginCheck(plugin, file, registry, err).run();
}

} // namespace phys
