"""The parts of a document as statements are looked for in them: short texts of terms, with the names that are meant."""
