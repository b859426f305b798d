"""The resolved system in rows and words, as documents, pages, explain and trace print it alike."""
