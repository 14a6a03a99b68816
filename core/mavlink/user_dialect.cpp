#include "core/mavlink/user_dialect.h"

#include "core/mavlink/dialect_xml.h"

namespace skyseal::mavlink {

namespace {

constexpr std::string_view kBuiltIn[] = {"minimal.xml",    "standard.xml",  "common.xml",    "uAvionix.xml",     "icarous.xml",
                                         "loweheiser.xml", "cubepilot.xml", "csAirLink.xml", "ardupilotmega.xml"};

} // namespace

Result<Dialect, InputError> loadUserDialect(const std::string &path)
{
    return readDialectXml(path, kBuiltIn).and_then([](const DialectDefinition &definition) {
        return Dialect::builtin().extended(definition);
    });
}

} // namespace skyseal::mavlink
