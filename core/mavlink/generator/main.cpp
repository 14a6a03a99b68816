// dialectgen ROOT.xml TYPED-LIST UNKNOWN-VALUES OUTPUT-FOLDER: writes the message tables, the enums, the message ids and the
// typed messages that core/mavlink compiles.
#include "core/mavlink/dialect_xml.h"
#include "core/mavlink/field_value.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

using namespace skyseal::mavlink;

namespace {

const char kHead[] = "// Generated from resources/dialects; do not edit.\n";

std::string quoted(const std::string &text)
{
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += '\\';
        out += c;
    }
    return out + '"';
}

const char *enumeratorOf(FieldType type)
{
    static const char *const kNames[] = {"Char",  "Uint8",  "Int8",  "Uint16", "Int16", "Uint32",
                                         "Int32", "Uint64", "Int64", "Float",  "Double"};
    return kNames[static_cast<int>(type)];
}

std::string cppTypeOf(FieldType type)
{
    if (type == FieldType::Char || type == FieldType::Float || type == FieldType::Double)
        return std::string(nameOf(type));
    return "std::" + std::string(nameOf(type));
}

/// GLOBAL_POSITION_INT -> GlobalPositionInt
std::string typeNameOf(const std::string &message)
{
    std::string out;
    bool upper = true;
    for (const char c : message) {
        if (c == '_') {
            upper = true;
            continue;
        }
        out += static_cast<char>(upper ? std::toupper(c) : std::tolower(c));
        upper = false;
    }
    return out;
}

FieldDefinition *findField(DialectDefinition &dialect, std::string_view message, std::string_view field)
{
    for (MessageDefinition &m : dialect.messages) {
        for (FieldDefinition &f : m.fields) {
            if (m.name == message && f.name == field)
                return &f;
        }
    }
    return nullptr;
}

/// Adds the values of unknown_values.txt to the fields. Returns the first line that names no field, has no value of its type or
/// no reason; empty if there is none.
std::string addUnknownValues(DialectDefinition &dialect, std::istream &list)
{
    for (std::string line; std::getline(list, line);) {
        if (line.empty() || line.front() == '#')
            continue;
        std::istringstream words(line);
        std::string name, number, reason;
        words >> name >> number >> reason;
        const std::size_t dot = name.find('.');
        FieldDefinition *field = findField(dialect, name.substr(0, dot), dot == name.npos ? "" : name.substr(dot + 1));
        const auto value = field ? parseFieldValue(field->type, number) : std::nullopt;
        if (!value || reason.empty())
            return line;
        field->unknown.push_back(value->bits());
    }
    return {};
}

void writeTables(const DialectDefinition &dialect, std::ostream &out)
{
    out << kHead << "#include \"core/mavlink/builtin_tables.h\"\n\nnamespace skyseal::mavlink::builtin {\n\nnamespace {\n\n";
    for (const MessageDefinition &m : dialect.messages) {
        for (const FieldDefinition &f : m.fields) {
            if (f.unknown.empty())
                continue;
            out << "constexpr std::uint64_t k" << m.name << '_' << f.name << "[] = {";
            for (const std::uint64_t bits : f.unknown)
                out << bits << "u, ";
            out << "};\n";
        }
        out << "constexpr FieldInfo k" << m.name << "[] = {\n";
        for (const FieldDefinition &f : m.fields) {
            out << "    {" << quoted(f.name) << ", FieldType::" << enumeratorOf(f.type) << ", " << int(f.arrayLength) << ", "
                << int(f.offset) << ", " << (f.extension ? "true" : "false") << ", " << (f.isMavlinkVersion ? "true" : "false")
                << ", " << quoted(f.enumName) << ", " << quoted(f.units) << ", " << quoted(f.printFormat) << ", "
                << (f.unknown.empty() ? "{}" : "k" + m.name + "_" + f.name) << "},\n";
        }
        out << "};\n";
    }
    out << "\nconstexpr MessageInfo kMessages[] = {\n";
    for (const MessageDefinition &m : dialect.messages) {
        out << "    {" << m.id << ", " << quoted(m.name) << ", " << int(m.crcExtra) << ", " << int(m.minLength) << ", "
            << int(m.maxLength) << ", " << m.targetSystemOffset << ", " << m.targetComponentOffset << ", k" << m.name << "},\n";
    }
    out << "};\n\n";
    for (const EnumDefinition &e : dialect.enums) {
        if (e.entries.empty())
            continue;
        out << "constexpr EnumEntry k" << e.name << "[] = {\n";
        for (const EnumEntryDefinition &entry : e.entries)
            out << "    {" << entry.value << "u, " << quoted(entry.name) << "},\n";
        out << "};\n";
    }
    out << "\nconstexpr EnumInfo kEnums[] = {\n";
    for (const EnumDefinition &e : dialect.enums)
        out << "    {" << quoted(e.name) << ", " << (e.bitmask ? "true" : "false") << ", "
            << (e.entries.empty() ? "{}" : "k" + e.name) << "},\n";
    out << "};\n\nconstexpr std::uint16_t kCommandsWithoutPlace[] = {\n";
    for (const EnumDefinition &e : dialect.enums) {
        for (const EnumEntryDefinition &entry : e.entries) {
            if (e.name == "MAV_CMD" && !entry.hasLocation)
                out << "    " << entry.value << ", // " << entry.name << '\n';
        }
    }
    out << "};\n\n} // namespace\n\nstd::span<const MessageInfo> messages() { return kMessages; }\nstd::span<const "
           "EnumInfo> enums() { return kEnums; }\nstd::span<const std::uint16_t> commandsWithoutPlace() { return "
           "kCommandsWithoutPlace; }\n\n"
           "} // namespace skyseal::mavlink::builtin\n";
}

void writeEnums(const DialectDefinition &dialect, std::ostream &out)
{
    out << kHead << "#pragma once\n\n#include <cstdint>\n\nnamespace skyseal::mavlink {\n\n";
    for (const EnumDefinition &e : dialect.enums) {
        const bool wide = std::any_of(e.entries.begin(), e.entries.end(),
                                      [](const auto &entry) { return entry.value > 0xffffffffu; });
        out << "enum " << e.name << " : std::uint" << (wide ? 64 : 32) << "_t {\n";
        for (const EnumEntryDefinition &entry : e.entries)
            out << "    " << entry.name << " = " << entry.value << (entry.value > 0x7fffffffu ? "u" : "") << ",\n";
        out << "};\n\n";
    }
    out << "} // namespace skyseal::mavlink\n";
}

void writeMessageIds(const DialectDefinition &dialect, std::ostream &out)
{
    out << kHead << "#pragma once\n\n#include <cstdint>\n\nnamespace skyseal::mavlink {\n\nenum MessageId : std::uint32_t {\n";
    for (const MessageDefinition &m : dialect.messages)
        out << "    MAVLINK_MSG_ID_" << m.name << " = " << m.id << ",\n";
    out << "};\n\n} // namespace skyseal::mavlink\n";
}

void writeMessage(const MessageDefinition &m, std::ostream &out)
{
    const std::string type = typeNameOf(m.name);
    out << "struct " << type << "\n{\n    static constexpr std::uint32_t kId = " << m.id
        << ";\n    static constexpr std::uint8_t kCrcExtra = " << int(m.crcExtra) << ", kMinLength = " << int(m.minLength)
        << ", kMaxLength = " << int(m.maxLength) << ";\n\n";
    for (const FieldDefinition &f : m.fields) {
        const std::string element = cppTypeOf(f.type);
        const std::string member = f.arrayLength ? "std::array<" + element + ", " + std::to_string(f.arrayLength) + ">"
                                                 : element;
        out << "    " << member << ' ' << f.name << (f.isMavlinkVersion ? " = 3" : "{}") << ";";
        if (!f.units.empty())
            out << " ///< " << f.units;
        out << '\n';
    }
    out << "\n    /// Bytes that the payload does not have read as zero.\n    static " << type
        << " decode(ByteView payload)\n    {\n"
        << "        const PayloadBytes<kMaxLength> raw(payload);\n        " << type << " out;\n";
    for (const FieldDefinition &f : m.fields)
        out << "        raw.load(" << int(f.offset) << ", out." << f.name << ");\n";
    out << "        return out;\n    }\n\n    /// Writes all kMaxLength bytes.\n    void encode(std::span<std::uint8_t, "
           "kMaxLength> out) const\n    {\n";
    for (const FieldDefinition &f : m.fields)
        out << "        storeField(out.data() + " << int(f.offset) << ", " << f.name << ");\n";
    out << "    }\n};\n\n";
    for (const FieldDefinition &f : m.fields) {
        if (f.unknown.empty())
            continue;
        out << "template<> inline constexpr std::array<" << cppTypeOf(f.type) << ", " << f.unknown.size() << "> kNotKnown<&"
            << type << "::" << f.name << ">{";
        for (const std::uint64_t bits : f.unknown)
            out << toText(FieldValue::fromBits(f.type, bits)) << ", ";
        out << "};\n\n";
    }
}

/// Does not rewrite a file that already has this content, so that a change of the generator does not rebuild all its users.
bool update(const std::string &path, const std::string &content)
{
    std::ifstream old(path, std::ios::binary);
    if (old && std::string(std::istreambuf_iterator<char>(old), {}) == content)
        return true;
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out << content;
    return out.flush().good();
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 5) {
        std::fprintf(stderr, "usage: dialectgen ROOT.xml TYPED-LIST UNKNOWN-VALUES OUTPUT-FOLDER\n");
        return 2;
    }
    auto dialect = readDialectXml(argv[1]);
    if (!dialect) {
        std::fprintf(stderr, "%s\n", dialect.error().text().c_str());
        return 1;
    }
    std::ifstream unknownValues(argv[3]);
    if (const std::string line = addUnknownValues(*dialect, unknownValues); !unknownValues.eof() || !line.empty()) {
        std::fprintf(stderr, "%s: expected MESSAGE.field, a value of its type and a reason: %s\n", argv[3], line.c_str());
        return 1;
    }
    std::set<std::string> typed;
    std::ifstream list(argv[2]);
    for (std::string name; list >> name;)
        typed.insert(name);

    std::ostringstream tables, enums, ids, messages;
    writeTables(*dialect, tables);
    writeEnums(*dialect, enums);
    writeMessageIds(*dialect, ids);
    messages << kHead
             << "#pragma once\n\n#include \"core/mavlink/enums.h\"\n#include \"core/mavlink/payload_bytes.h\"\n\nnamespace "
                "skyseal::mavlink {\n\n";
    for (const MessageDefinition &message : dialect->messages) {
        if (typed.erase(message.name))
            writeMessage(message, messages);
    }
    messages << "} // namespace skyseal::mavlink\n";
    if (!typed.empty()) {
        std::fprintf(stderr, "%s: no message is named %s\n", argv[2], typed.begin()->c_str());
        return 1;
    }
    const std::string folder = argv[4];
    return update(folder + "/builtin_tables.cpp", tables.str()) && update(folder + "/enums.h", enums.str())
            && update(folder + "/message_ids.h", ids.str()) && update(folder + "/messages.h", messages.str())
        ? 0
        : 1;
}
