// The programs that a sweep starts beside itself: one that cannot be started is named, with what failed and the reason.
#include "core/crypto/system_random.h"
#include "core/experiment/lab.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::experiment;

class LabTest : public QObject
{
    Q_OBJECT

private:
    /// A program whose interpreter does not exist.
    QString unusable(const char *name) const
    {
        QFile file(m_folder.filePath(QLatin1String(name)));
        if (!file.open(QIODevice::WriteOnly) || file.write("#!/no/such/interpreter\n") < 0
            || !file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner))
            qFatal("cannot write %s", name);
        return file.fileName();
    }

    QTemporaryDir m_folder;

private Q_SLOTS:
    void programThatCannotStartIsNamed()
    {
        crypto::SystemRandom random;
        const auto lab = Lab::create({unusable("skyseal-sim"), unusable("skyseal-air"), unusable("skyseal-cli")}, random);
        QVERIFY(lab);
        std::vector<std::string> said;
        connect(lab->get(), &Lab::ended, this, [&said](const Reason &problem) { said.push_back(problem.text()); });
        (*lab)->start(Load::Natural, Condition{}, 1);
        EVENTUALLY(!said.empty());
        for (const std::string &line : said)
            QVERIFY2(line.find(" could not be started: ") == std::string("skyseal-sim").size(), line.c_str());
    }

    void missingProgramIsNamed()
    {
        crypto::SystemRandom random;
        const auto lab = Lab::create({m_folder.filePath(QStringLiteral("none")), {}, {}}, random);
        QVERIFY(!lab);
        QCOMPARE(lab.error().text(), std::string("skyseal-sim: was not found beside this program or in PATH"));
    }
};

SKYSEAL_TEST(LabTest)
#include "lab_test.moc"
