# Stands in for a ParaView of somebody's own: a test looks whether -DParaView_DIR leads here.
message(FATAL_ERROR "this is the ParaView that was given")
