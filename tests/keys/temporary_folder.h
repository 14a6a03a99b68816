// A folder for the files of one test.
#pragma once

#include <QtCore/QTemporaryDir>

#include <fstream>
#include <iterator>
#include <string>
#include <sys/stat.h>

namespace skyseal::test {

constexpr uid_t kSomebodyElse = 65534; ///< owner of a file that is not ours

class TemporaryFolder
{
public:
    std::string path(const char *name) const { return m_folder.filePath(QLatin1String(name)).toStdString(); }

    /// Writes a file with the given permissions and gives its path.
    std::string write(const char *name, const std::string &content, mode_t mode = 0600) const
    {
        const std::string file = path(name);
        std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
        ::chmod(file.c_str(), mode);
        return file;
    }

private:
    QTemporaryDir m_folder;
};

inline std::string readText(const std::string &path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline mode_t modeOf(const std::string &path)
{
    struct stat status
    {};
    return ::stat(path.c_str(), &status) == 0 ? status.st_mode & 0777 : 0;
}

} // namespace skyseal::test
