# Precompiled headers of the standard library and Qt, one for each kind of target: protocol (no Qt), engine (Qt Core; also
# the programs), ui (Widgets), tests (QtTest), ui_tests (QtTest and Widgets). Each unit still includes the headers that it
# uses, so that it also compiles with SKYSEAL_PCH=OFF.
option(SKYSEAL_PCH "Precompile the headers of the standard library and Qt" ON)

set(protocol_headers <algorithm> <array> <chrono> <cstdint> <functional> <map> <memory> <optional> <span> <string>
  <string_view> <utility> <variant> <vector> <tl/expected.hpp>)
set(engine_headers ${protocol_headers} <deque> <QtCore/QByteArray> <QtCore/QCoreApplication> <QtCore/QJsonObject>
  <QtCore/QObject> <QtCore/QString> <QtCore/QStringList> <QtCore/QTimer>)
set(ui_headers ${engine_headers} <QtCore/QAbstractItemModel> <QtCore/QSettings> <QtGui/QAction> <QtGui/QIcon>
  <QtGui/QPainter> <QtWidgets/QApplication> <QtWidgets/QBoxLayout> <QtWidgets/QComboBox> <QtWidgets/QDialog>
  <QtWidgets/QFormLayout> <QtWidgets/QHeaderView> <QtWidgets/QLabel> <QtWidgets/QMainWindow> <QtWidgets/QMenu>
  <QtWidgets/QPushButton> <QtWidgets/QTreeView> <QtWidgets/QWidget>)
# QtTest's headers depend on the modules of Qt that their target links: Network in all tests, Widgets in those of windows.
set(tests_headers ${protocol_headers} <QtCore/QCoreApplication> <QtCore/QElapsedTimer> <QtCore/QTemporaryDir> <QtTest/QTest>
  <QtTest/QSignalSpy>)
set(ui_tests_headers ${ui_headers} <QtTest/QTest> <QtTest/QSignalSpy>)

function(skyseal_precompiled_kind kind)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/precompiled_${kind}.cpp)
  file(GENERATE OUTPUT ${source} CONTENT "")
  add_library(skyseal_precompiled_${kind} OBJECT ${source})
  target_link_libraries(skyseal_precompiled_${kind} PRIVATE skyseal_options ${ARGN})
  target_precompile_headers(skyseal_precompiled_${kind} PRIVATE ${${kind}_headers})
endfunction()

# ccache caches units with a precompiled header only with this option of GCC and a sloppiness that CMakeLists.txt sets.
if(SKYSEAL_PCH)
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  skyseal_precompiled_kind(protocol skyseal_hardening)
  skyseal_precompiled_kind(engine skyseal_hardening Qt6::Core)
  if(SKYSEAL_UI)
    skyseal_precompiled_kind(ui skyseal_hardening Qt6::Widgets)
  endif()
  if(SKYSEAL_TESTS)
    # Qt6::Test defines the source folder of each target (for QFINDTESTDATA, which no test uses). With that definition, no two
    # folders could share a precompiled header.
    set_target_properties(Qt6::Test PROPERTIES INTERFACE_COMPILE_DEFINITIONS QT_TESTLIB_LIB)
    skyseal_precompiled_kind(tests Qt6::Test Qt6::Network)
    target_compile_options(skyseal_precompiled_tests PRIVATE ${SKYSEAL_TEST_OPTIONS})
    if(SKYSEAL_UI)
      skyseal_precompiled_kind(ui_tests Qt6::Test Qt6::Network Qt6::Widgets)
      target_compile_options(skyseal_precompiled_ui_tests PRIVATE ${SKYSEAL_TEST_OPTIONS})
    endif()
  endif()
endif()

# skyseal_precompile(TARGET KIND)
function(skyseal_precompile target kind)
  if(SKYSEAL_PCH)
    target_precompile_headers(${target} REUSE_FROM skyseal_precompiled_${kind})
    target_compile_options(${target} PRIVATE -fPIC) # as the header, where CMake would say -fPIE for a program
  endif()
endfunction()

# skyseal_precompile_layer(TARGET QT): with those of engine if QT is true, else with those of protocol.
function(skyseal_precompile_layer target qt)
  if(qt)
    skyseal_precompile(${target} engine)
  else()
    skyseal_precompile(${target} protocol)
  endif()
endfunction()
