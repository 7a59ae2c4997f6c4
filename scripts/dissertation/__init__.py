"""The tables and figures of C. Lindsay's dissertation, each made again by a function of one of these files."""
