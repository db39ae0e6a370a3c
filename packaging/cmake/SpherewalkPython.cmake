# SPDX-License-Identifier: GPL-3.0-or-later
# The interpreter that scripts and tests run with, and what `import spherewalk` is built with.

# Debian's modules (NumPy, pybind11's headers for it) belong to Debian's own interpreter, whichever comes first on the path;
# another one is asked for with -DPython3_EXECUTABLE or -DPython3_ROOT_DIR, or by an activated virtual environment.
if(NOT DEFINED Python3_EXECUTABLE AND NOT DEFINED Python3_ROOT_DIR AND NOT DEFINED ENV{VIRTUAL_ENV})
  find_program(Python3_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH DOC "Python's interpreter")
  if(NOT Python3_EXECUTABLE)
    unset(Python3_EXECUTABLE CACHE)
  endif()
endif()
find_package(Python3 COMPONENTS Interpreter OPTIONAL_COMPONENTS Development.Module NumPy QUIET)
if(Python3_FOUND AND TARGET Python3::Module AND TARGET Python3::NumPy)
  find_package(pybind11 2.6 CONFIG QUIET)
  set_package_properties(pybind11 PROPERTIES PURPOSE "import spherewalk (app/python)")
endif()

option(SPHEREWALK_PYTHON "Build the Python module, if Python's headers, NumPy and pybind11 are found" ON)
if(SPHEREWALK_PYTHON AND NOT pybind11_FOUND)
  set(SPHEREWALK_PYTHON OFF)
endif()
add_feature_info(python SPHEREWALK_PYTHON "import spherewalk (needs pybind11-dev python3-dev python3-numpy)")

# Where the interpreter of the same prefix looks: Debian's own place, or that of the interpreter.
if(SPHEREWALK_PYTHON AND NOT SPHEREWALK_PYTHON_DIR)
  execute_process(COMMAND ${Python3_EXECUTABLE} -c "import sysconfig as s
if hasattr(s, 'get_preferred_scheme'):
    scheme = 'deb_system' if 'deb_system' in s.get_scheme_names() else s.get_preferred_scheme('prefix')
    print(s.get_path('platlib', scheme, {'base': '', 'platbase': ''}).lstrip('/'))
else: # before 3.10
    from distutils.sysconfig import get_python_lib
    print(get_python_lib(plat_specific=True, prefix='').lstrip('/'))"
    OUTPUT_VARIABLE directory OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT directory)
    message(FATAL_ERROR "${Python3_EXECUTABLE} does not say where its modules are installed.")
  endif()
  set(SPHEREWALK_PYTHON_DIR ${directory} CACHE STRING "Where the Python module is installed, below the prefix")
endif()
