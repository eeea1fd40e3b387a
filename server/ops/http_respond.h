// Answers one request of HTTP: the callback that libmicrohttpd makes for it.
#pragma once

#include <microhttpd.h>

#include <cstddef>

namespace saccade {

// `site`: an HttpSite. Answers when the head of a request has come, without reading its body. The connection
// then closes, or leaves HTTP.
MHD_Result respond(void* site, MHD_Connection* client, const char* path, const char* method, const char*,
                   const char*, std::size_t* body_bytes, void** upgrade);

}  // namespace saccade
