"""The protocol, written once for the blocking and the asyncio form of the client.

Everything that waits is a coroutine over a Network. The asyncio form awaits these coroutines. The blocking form runs
them with run(): its network blocks in place of suspending, so that no event loop is needed.
"""
