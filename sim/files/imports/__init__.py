"""What others have measured, as scenes and crowds: trackways of prints, ways of people."""
