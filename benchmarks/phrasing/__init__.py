"""Facts of a dialect, each true and once more with something wrong in it, for phrasings of documents."""
