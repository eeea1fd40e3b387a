"""Data sets that saccade-farm has made. server/farm/README.md shows the folder; saccade.Dataset reads it."""
