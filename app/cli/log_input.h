// Opens the file or standard input that a command reads MAVLink from.
#pragma once

#include <QtCore/QString>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>

namespace skyseal::app {

class LogInput
{
public:
    /// "-" is standard input. Returns an error if it cannot be read.
    std::optional<std::string> open(const QString &file)
    {
        if (file == QLatin1String("-")) {
            std::ios::sync_with_stdio(false);
            m_stream = &std::cin;
            return std::nullopt;
        }
        const std::string path = file.toStdString();
        std::error_code ignored;
        if (std::filesystem::is_directory(path, ignored))
            return path + ": is a folder";
        m_file.open(path, std::ios::binary);
        if (!m_file)
            return path + ": " + std::strerror(errno);
        return std::nullopt;
    }

    std::istream &stream() { return *m_stream; }

private:
    std::ifstream m_file;
    std::istream *m_stream = &m_file;
};

} // namespace skyseal::app
