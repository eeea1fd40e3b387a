# find_package(Saccade) gives the target Saccade::client.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(Protobuf)
find_dependency(cppzmq)
find_dependency(ZLIB)
find_dependency(zstd)
include(${CMAKE_CURRENT_LIST_DIR}/Saccade.cmake)
