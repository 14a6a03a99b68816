#include "core/mavlink/dialect_xml.h"

#include "core/mavlink/field_value.h"

#include <pugixml.hpp>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

namespace skyseal::mavlink {

namespace {

constexpr std::size_t kMaxFileSize = 16u << 20;
constexpr std::size_t kMaxFiles = 64;
constexpr int kMaxDepth = 8;
constexpr std::size_t kMaxMessages = 8192;
constexpr std::size_t kMaxEnums = 8192;
constexpr std::size_t kMaxEntries = 8192; // of one enum

/// Positions of the lines of a text, to name them in errors.
class Lines
{
public:
    explicit Lines(std::string_view text)
    {
        for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1))
            m_ends.push_back(at);
    }

    std::size_t lineOf(std::ptrdiff_t offset) const
    {
        const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
        return 1 + static_cast<std::size_t>(std::lower_bound(m_ends.begin(), m_ends.end(), at) - m_ends.begin());
    }

private:
    std::vector<std::size_t> m_ends;
};

/// Thrown by the reader from any depth, with the reason; caught in this file.
struct Refused
{
    InputError error;
};

/// "12" or "0x0c".
std::optional<std::uint64_t> parsePlainNumber(std::string_view text)
{
    int base = 10;
    if (text.starts_with("0x") || text.starts_with("0X")) {
        base = 16;
        text.remove_prefix(2);
    }
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    return error == std::errc() && end == text.data() + text.size() && !text.empty() ? std::optional(value) : std::nullopt;
}

/// The same, or "2**5", as some definitions write bits.
std::optional<std::uint64_t> parseNumber(std::string_view text)
{
    constexpr std::string_view kPowerOfTwo = "2**";
    if (!text.starts_with(kPowerOfTwo))
        return parsePlainNumber(text);
    const auto exponent = parsePlainNumber(text.substr(kPowerOfTwo.size()));
    return exponent && *exponent < 64 ? std::optional(std::uint64_t(1) << *exponent) : std::nullopt;
}

bool isName(std::string_view text)
{
    return !text.empty() && text.size() <= 100
        && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

class Reader
{
public:
    explicit Reader(std::span<const std::string_view> known) : m_known(known) {}

    DialectDefinition read(const std::string &path)
    {
        readFile(path, 0);
        std::sort(m_result.messages.begin(), m_result.messages.end(), [](const auto &a, const auto &b) { return a.id < b.id; });
        for (auto &[name, definition] : m_enums) {
            std::stable_sort(definition.entries.begin(), definition.entries.end(),
                             [](const auto &a, const auto &b) { return a.value < b.value; });
            m_result.enums.push_back(std::move(definition));
        }
        return std::move(m_result);
    }

private:
    [[noreturn]] void refuse(const pugi::xml_node &node, std::string message) const
    {
        throw Refused{{std::move(message), m_file, lineOf(node)}};
    }

    std::size_t lineOf(const pugi::xml_node &node) const { return m_lines.lineOf(node.offset_debug()); }

    void readFile(const std::string &path, int depth)
    {
        std::error_code error;
        const std::string canonical = std::filesystem::weakly_canonical(path, error).string();
        if (!m_seen.insert(error ? path : canonical).second)
            return;
        if (m_seen.size() > kMaxFiles || depth > kMaxDepth)
            throw Refused{{"too many includes, or nested too deeply", path}};
        const std::uintmax_t size = std::filesystem::file_size(path, error);
        if (error)
            throw Refused{{"cannot be read: " + error.message(), path}};
        if (size > kMaxFileSize)
            throw Refused{{"is larger than 16 MiB", path}};
        std::ifstream file(path, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        if (!file)
            throw Refused{{"cannot be read", path}};

        pugi::xml_document document;
        const auto outerFile = std::exchange(m_file, path);
        const auto outerLines = std::exchange(m_lines, Lines(text));
        const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
        if (!parsed)
            throw Refused{
                {std::string("is not well-formed XML: ") + parsed.description(), path, m_lines.lineOf(parsed.offset)}};
        const pugi::xml_node root = document.child("mavlink");
        if (!root)
            throw Refused{{"has no <mavlink> element", path, 1}};
        for (const pugi::xml_node include : root.children("include")) {
            const std::filesystem::path name(include.text().get());
            if (name.empty() || name.is_absolute())
                refuse(include, "an include needs a relative file name");
            const std::filesystem::path target = std::filesystem::path(path).parent_path() / name;
            if (std::find(m_known.begin(), m_known.end(), name.string()) == m_known.end()
                || std::filesystem::exists(target, error))
                readFile(target.string(), depth + 1);
        }
        for (const pugi::xml_node node : root.child("enums").children("enum"))
            readEnum(node);
        for (const pugi::xml_node node : root.child("messages").children("message"))
            readMessage(node);
        m_file = outerFile;
        m_lines = outerLines;
    }

    void readEnum(const pugi::xml_node &node)
    {
        const std::string name = node.attribute("name").value();
        if (!isName(name))
            refuse(node, "an enum needs a name of letters, digits and underscores");
        if (m_enums.size() >= kMaxEnums)
            refuse(node, "more than " + std::to_string(kMaxEnums) + " enums");
        EnumDefinition &definition = m_enums[name];
        definition.name = name;
        definition.bitmask |= node.attribute("bitmask").as_bool();
        std::uint64_t next = definition.entries.empty() ? 0 : definition.entries.back().value + 1;
        for (const pugi::xml_node entry : node.children("entry")) {
            const std::string entryName = entry.attribute("name").value();
            const std::string_view value = entry.attribute("value").value();
            const auto number = value.empty() ? std::optional(next) : parseNumber(value);
            if (!isName(entryName) || !number)
                refuse(entry, "an entry of " + name + " needs a name and a whole number as its value");
            next = *number + 1;
            const auto other = std::find_if(definition.entries.begin(), definition.entries.end(),
                                            [&](const auto &earlier) { return earlier.value == *number; });
            if (other == definition.entries.end())
                definition.entries.push_back(
                    {*number, entryName, std::string_view(entry.attribute("hasLocation").value()) != "false"});
            else if (other->name != entryName)
                refuse(entry, "value " + std::to_string(*number) + " of " + name + " is " + other->name + " already");
            if (definition.entries.size() > kMaxEntries)
                refuse(entry, "enum " + name + " has more than " + std::to_string(kMaxEntries) + " entries");
        }
    }

    void readMessage(const pugi::xml_node &node)
    {
        MessageDefinition message;
        message.name = node.attribute("name").value();
        message.file = m_file;
        message.line = lineOf(node);
        const auto id = parseNumber(node.attribute("id").value());
        if (!isName(message.name) || !id || *id > 0xffffff)
            refuse(node, "a message needs a name and an id of 0 to 16777215");
        message.id = static_cast<std::uint32_t>(*id);
        if (!m_ids.insert(message.id).second || !m_names.insert(message.name).second)
            refuse(node, "message " + message.name + " (id " + std::to_string(message.id) + ") is defined twice");
        if (m_ids.size() > kMaxMessages)
            refuse(node, "more than " + std::to_string(kMaxMessages) + " messages");
        bool extension = false;
        for (const pugi::xml_node child : node.children()) {
            if (std::string_view(child.name()) == "extensions")
                extension = true;
            else if (std::string_view(child.name()) == "field")
                message.fields.push_back(readField(child, message, extension));
        }
        if (message.fields.empty() || message.fields.front().extension)
            refuse(node, "message " + message.name + " has no fields");
        if (!layOut(message))
            refuse(node, "message " + message.name + " is longer than 255 bytes");
        m_result.messages.push_back(std::move(message));
    }

    FieldDefinition readField(const pugi::xml_node &node, const MessageDefinition &message, bool extension) const
    {
        FieldDefinition field;
        field.name = node.attribute("name").value();
        if (!isName(field.name))
            refuse(node, "a field of " + message.name + " needs a name");
        if (std::any_of(message.fields.begin(), message.fields.end(),
                        [&](const auto &other) { return other.name == field.name; }))
            refuse(node, "field " + field.name + " stands twice in " + message.name);
        std::string_view type = node.attribute("type").value();
        if (const auto bracket = type.find('['); bracket != type.npos) {
            const auto length = type.ends_with(']') ? parseNumber(type.substr(bracket + 1, type.size() - bracket - 2))
                                                    : std::nullopt;
            if (!length || *length == 0 || *length > 255)
                refuse(node, "field " + field.name + " needs an array length of 1 to 255");
            field.arrayLength = static_cast<std::uint8_t>(*length);
            type = type.substr(0, bracket);
        }
        field.isMavlinkVersion = type == "uint8_t_mavlink_version";
        if (field.isMavlinkVersion)
            type = "uint8_t";
        bool known = false;
        for (int i = 0; i <= static_cast<int>(FieldType::Double) && !known; ++i) {
            field.type = static_cast<FieldType>(i);
            known = nameOf(field.type) == type;
        }
        if (!known)
            refuse(node, "field " + field.name + " has the unknown type \"" + std::string(type.substr(0, 40)) + '"');
        field.extension = extension;
        field.enumName = node.attribute("enum").value();
        field.units = node.attribute("units").value();
        field.printFormat = node.attribute("print_format").value();
        field.unknown = readUnknown(node.attribute("invalid").value(), field);
        return field;
    }

    /// The values of an `invalid` attribute: "UINT16_MAX", "-1", "[0]" for each element of an array, an entry of the field's
    /// enum (https://mavlink.io/en/guide/xml_schema.html). "[NaN:]" speaks of the first element for all. Texts that state no
    /// value are ignored, since a dialect can be used without them.
    std::vector<std::uint64_t> readUnknown(std::string_view text, const FieldDefinition &field) const
    {
        if (field.type == FieldType::Char) // a text says so by being empty
            return {};
        if (text.starts_with('[') && text.ends_with(']'))
            text = text.substr(1, text.size() - 2);
        static constexpr std::pair<std::string_view, std::string_view> kLimits[] = {
            {"UINT8_MAX", "255"}, {"UINT16_MAX", "65535"}, {"UINT32_MAX", "4294967295"},
            {"INT8_MAX", "127"},  {"INT16_MAX", "32767"},  {"INT32_MAX", "2147483647"},
        };
        for (const auto &[name, number] : kLimits) {
            if (text == name)
                text = number;
        }
        if (const auto names = m_enums.find(field.enumName); names != m_enums.end()) {
            for (const EnumEntryDefinition &entry : names->second.entries) {
                if (entry.name == text)
                    return {entry.value};
            }
        }
        auto value = parseFieldValue(field.type, text);
        if (const auto whole = value ? std::nullopt : parsePlainNumber(text)) // "0xFFFF" of a float
            value = FieldValue::fromNumber(field.type, static_cast<double>(*whole));
        return value && isKnown(*value, {}) ? std::vector{value->bits()} : std::vector<std::uint64_t>();
    }

    DialectDefinition m_result;
    std::map<std::string, EnumDefinition> m_enums;
    std::set<std::string> m_seen;
    std::set<std::uint32_t> m_ids;
    std::set<std::string> m_names;
    std::span<const std::string_view> m_known;
    std::string m_file;
    Lines m_lines{{}};
};

} // namespace

Result<DialectDefinition, InputError> readDialectXml(const std::string &path, std::span<const std::string_view> known)
{
    try {
        return Reader(known).read(path);
    } catch (const Refused &refused) {
        return tl::unexpected(refused.error);
    }
}

} // namespace skyseal::mavlink
