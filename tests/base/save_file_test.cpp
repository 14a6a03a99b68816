// A file is saved as a whole or stays as it was: limits on its size, permissions, links, pipes.
#include "core/base/save_file.h"
#include "tests/support/eventually.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <thread>

#include <sys/stat.h>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::test;

class SaveFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder.emplace();
        QVERIFY(m_folder->isValid());
        m_path = m_folder->filePath(QStringLiteral("file"));
    }
    void savesAndReplaces();
    void fullDiskKeepsTheOldFile_data();
    void fullDiskKeepsTheOldFile();
    void partIsNotSaved();
    void permissionsStay();
    void linkStays();
    void pipeIsWrittenInto();
    void folderIsRefused();
    void missingFolderIsRefused();

private:
    static bool save(const QString &path, std::string_view content)
    {
        return saveFile(path.toStdString(), asBytes(content)).has_value();
    }
    QByteArray content() const
    {
        QFile file(m_path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("none");
    }
    /// All that is in the folder.
    QStringList names() const
    {
        return QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot);
    }
    static ::mode_t modeOf(const QString &path)
    {
        struct stat status
        {};
        return ::stat(QFile::encodeName(path).constData(), &status) == 0 ? status.st_mode & 0777 : 0;
    }

    std::optional<QTemporaryDir> m_folder;
    QString m_path;
};

void SaveFileTest::savesAndReplaces()
{
    QVERIFY(save(m_path, "first"));
    QCOMPARE(content(), QByteArray("first"));
    QVERIFY(save(m_path, ""));
    QCOMPARE(content(), QByteArray());
    QCOMPARE(names(), QStringList{QStringLiteral("file")});
}

void SaveFileTest::fullDiskKeepsTheOldFile_data()
{
    QTest::addColumn<int>("size"); // of a file that a library would write in one go at its end, and of a large one
    QTest::newRow("small") << 101;
    QTest::newRow("large") << 1'000'000;
}

void SaveFileTest::fullDiskKeepsTheOldFile()
{
    QFETCH(int, size);
    const auto saveBeyondLimit = [this, size] {
        const FileSizeLimit limit(100);
        return saveFile(m_path.toStdString(), asBytes(std::string(static_cast<std::size_t>(size), 'x')));
    };
    const auto none = saveBeyondLimit();
    QVERIFY(!none);
    QCOMPARE(QString::fromStdString(none.error().text()), m_path + QStringLiteral(": cannot be written: File too large"));
    QCOMPARE(names(), QStringList()); // not even an empty one
    QVERIFY(save(m_path, "good"));
    QVERIFY(!saveBeyondLimit());
    QCOMPARE(content(), QByteArray("good"));
    QCOMPARE(names(), QStringList{QStringLiteral("file")});
}

void SaveFileTest::partIsNotSaved()
{
    QVERIFY(save(m_path, "good"));
    {
        auto file = NewFile::saving(m_path.toStdString());
        QVERIFY(file && file->write(asBytes("part")));
        const FileSizeLimit limit(5);
        QVERIFY(file->write(asBytes("4")) && !file->write(asBytes("56")));
    } // without commit()
    QCOMPARE(content(), QByteArray("good"));
    QCOMPARE(names(), QStringList{QStringLiteral("file")});
    auto file = NewFile::saving(m_path.toStdString());
    QVERIFY(file);
    {
        const FileSizeLimit limit(0);
        QVERIFY(!file->write(asBytes("lost")));
    }
    QVERIFY(!file->write(asBytes("more"))); // though the disk would take it now
    QVERIFY(!file->commit());
    QCOMPARE(content(), QByteArray("good"));
}

void SaveFileTest::permissionsStay()
{
    const ::mode_t mask = ::umask(027);
    const bool saved = save(m_path, "new");
    ::umask(mask);
    QVERIFY(saved);
    QCOMPARE(modeOf(m_path), ::mode_t(0640)); // as any new file
    QCOMPARE(::chmod(QFile::encodeName(m_path).constData(), 0604), 0);
    QVERIFY(save(m_path, "newer"));
    QCOMPARE(modeOf(m_path), ::mode_t(0604));
}

void SaveFileTest::linkStays()
{
    const QString target = m_folder->filePath(QStringLiteral("target"));
    QVERIFY(QFile::link(QStringLiteral("target"), m_path));
    for (const char *text : {"first", "second"}) { // a link to nothing, then to a file
        QVERIFY(save(m_path, text));
        QCOMPARE(content(), QByteArray(text));
        QVERIFY(QFileInfo(m_path).isSymLink() && QFileInfo(target).isFile());
    }
}

void SaveFileTest::pipeIsWrittenInto()
{
    QCOMPARE(::mkfifo(QFile::encodeName(m_path).constData(), 0600), 0);
    QVERIFY(NewFile::saving(m_path.toStdString())); // a look whether it can be written does not wait for a reader
    QByteArray read;
    std::thread reader([&] { read = content(); });
    const bool saved = save(m_path, "through");
    reader.join();
    QVERIFY(saved);
    QCOMPARE(read, QByteArray("through"));
    QCOMPARE(names(), QStringList{QStringLiteral("file")});
    struct stat status
    {};
    QVERIFY(::stat(QFile::encodeName(m_path).constData(), &status) == 0 && S_ISFIFO(status.st_mode));
}

void SaveFileTest::folderIsRefused()
{
    const auto saved = saveFile(m_folder->path().toStdString(), asBytes("x"));
    QVERIFY(!saved);
    QCOMPARE(saved.error().text(), m_folder->path().toStdString() + ": cannot be written: Is a directory");
}

void SaveFileTest::missingFolderIsRefused()
{
    const auto saved = saveFile(m_folder->filePath(QStringLiteral("none/file")).toStdString(), asBytes("x"));
    QVERIFY(!saved);
    QVERIFY(
        QByteArray::fromStdString(saved.error().text()).endsWith("none/file: cannot be written: No such file or directory"));
}

SKYSEAL_TEST_APPLESS(SaveFileTest)
#include "save_file_test.moc"
